#include "vulkan/vulkan_compute.h"

#include <cstdio>
#include <cstring>

namespace marrow::test {
namespace {

template <class Info>
Info of_type(VkStructureType type) {
  Info out = {};
  out.sType = type;
  return out;
}

constexpr const char* kValidation = "VK_LAYER_KHRONOS_validation";

bool has_validation() {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  for (const VkLayerProperties& layer : layers)
    if (std::strcmp(layer.layerName, kValidation) == 0) return true;
  return false;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_complaint(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
  std::fprintf(stderr, "%s\n", data->pMessage);
  ++*static_cast<unsigned*>(count);
  return VK_FALSE;
}

}  // namespace

struct VulkanCompute::Resident {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  void* bytes = nullptr;  // mapped
};

struct VulkanCompute::Pass {
  std::vector<Resident> buffers;  // by binding; without a buffer where there is no such binding
  VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
  VkDescriptorPool descriptors = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkShaderModule module = VK_NULL_HANDLE;
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkCommandPool commands = VK_NULL_HANDLE;
};

VulkanCompute::~VulkanCompute() {
  if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy_messenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy_messenger(instance_, messenger_, nullptr);
  }
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

void VulkanCompute::create_instance() {
  validated_ = has_validation();
  auto application = of_type<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.apiVersion = VK_API_VERSION_1_0;
  auto listen = of_type<VkDebugUtilsMessengerCreateInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
  listen.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT;
  listen.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  listen.pfnUserCallback = on_complaint;
  listen.pUserData = &complaints_;
  const char* const extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  auto info = of_type<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  info.enabledLayerCount = info.enabledExtensionCount = validated_ ? 1 : 0;
  info.ppEnabledLayerNames = &kValidation;
  info.ppEnabledExtensionNames = &extension;
  if (vkCreateInstance(&info, nullptr, &instance_) != VK_SUCCESS) return;
  if (!validated_) return;
  const auto create_messenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  create_messenger(instance_, &listen, nullptr, &messenger_);
}

bool VulkanCompute::create_device() {
  std::uint32_t count = 1;
  const VkResult found = vkEnumeratePhysicalDevices(instance_, &count, &physical_);
  if ((found != VK_SUCCESS && found != VK_INCOMPLETE) || count == 0) return false;
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical_, &properties);
  name_ = properties.deviceName;
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
  while (family_ < count && (families[family_].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) ++family_;
  if (family_ == count) return false;
  const float priority = 1;
  auto queue = of_type<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = of_type<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  if (vkCreateDevice(physical_, &info, nullptr, &device_) != VK_SUCCESS) return false;
  vkGetDeviceQueue(device_, family_, 0, &queue_);
  return true;
}

bool VulkanCompute::open() {
  create_instance();
  return instance_ != VK_NULL_HANDLE && create_device();
}

bool VulkanCompute::create(const ComputeBuffer& from, Resident& out) {
  auto info = of_type<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = from.bytes.size();
  info.usage = from.type == VK_DESCRIPTOR_TYPE_STORAGE_BUFFER ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT
                                                              : VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
  if (vkCreateBuffer(device_, &info, nullptr, &out.buffer) != VK_SUCCESS) return false;
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device_, out.buffer, &needs);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
  constexpr VkMemoryPropertyFlags kWanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  auto allocation = of_type<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
  allocation.allocationSize = needs.size;
  while (allocation.memoryTypeIndex < memory.memoryTypeCount &&
         ((needs.memoryTypeBits >> allocation.memoryTypeIndex & 1) == 0 ||
          (memory.memoryTypes[allocation.memoryTypeIndex].propertyFlags & kWanted) != kWanted))
    ++allocation.memoryTypeIndex;
  if (vkAllocateMemory(device_, &allocation, nullptr, &out.memory) != VK_SUCCESS ||
      vkBindBufferMemory(device_, out.buffer, out.memory, 0) != VK_SUCCESS ||
      vkMapMemory(device_, out.memory, 0, VK_WHOLE_SIZE, 0, &out.bytes) != VK_SUCCESS)
    return false;
  std::memcpy(out.bytes, from.bytes.data(), from.bytes.size());
  return true;
}

void VulkanCompute::destroy(Pass& pass) {
  vkDestroyCommandPool(device_, pass.commands, nullptr);
  vkDestroyPipeline(device_, pass.pipeline, nullptr);
  vkDestroyShaderModule(device_, pass.module, nullptr);
  vkDestroyPipelineLayout(device_, pass.layout, nullptr);
  vkDestroyDescriptorPool(device_, pass.descriptors, nullptr);
  vkDestroyDescriptorSetLayout(device_, pass.set_layout, nullptr);
  for (const Resident& buffer : pass.buffers) {
    vkDestroyBuffer(device_, buffer.buffer, nullptr);
    vkFreeMemory(device_, buffer.memory, nullptr);
  }
}

// Buffers, and the set that has them.
bool VulkanCompute::describe(const std::vector<ComputeBuffer>& buffers, Pass& pass) {
  pass.buffers.resize(buffers.size());
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (std::uint32_t i = 0; i < buffers.size(); ++i) {
    if (buffers[i].bytes.empty()) continue;
    if (!create(buffers[i], pass.buffers[i])) return false;
    bindings.push_back({i, buffers[i].type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  }
  auto layout = of_type<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  layout.bindingCount = static_cast<std::uint32_t>(bindings.size());
  layout.pBindings = bindings.data();
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, layout.bindingCount},
                                        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, layout.bindingCount}};
  auto pool = of_type<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  pool.maxSets = 1;
  pool.poolSizeCount = 2;
  pool.pPoolSizes = sizes;
  if (vkCreateDescriptorSetLayout(device_, &layout, nullptr, &pass.set_layout) != VK_SUCCESS ||
      vkCreateDescriptorPool(device_, &pool, nullptr, &pass.descriptors) != VK_SUCCESS)
    return false;
  auto set = of_type<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  set.descriptorPool = pass.descriptors;
  set.descriptorSetCount = 1;
  set.pSetLayouts = &pass.set_layout;
  if (vkAllocateDescriptorSets(device_, &set, &pass.set) != VK_SUCCESS) return false;
  for (const VkDescriptorSetLayoutBinding& binding : bindings) {
    const VkDescriptorBufferInfo whole{pass.buffers[binding.binding].buffer, 0, VK_WHOLE_SIZE};
    auto write = of_type<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    write.dstSet = pass.set;
    write.dstBinding = binding.binding;
    write.descriptorCount = 1;
    write.descriptorType = binding.descriptorType;
    write.pBufferInfo = &whole;
    vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
  }
  return true;
}

bool VulkanCompute::build(const std::vector<std::uint32_t>& spirv, Pass& pass) {
  auto layout = of_type<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &pass.set_layout;
  auto module = of_type<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  module.codeSize = 4 * spirv.size();
  module.pCode = spirv.data();
  if (vkCreatePipelineLayout(device_, &layout, nullptr, &pass.layout) != VK_SUCCESS ||
      vkCreateShaderModule(device_, &module, nullptr, &pass.module) != VK_SUCCESS)
    return false;
  auto pipeline = of_type<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
  pipeline.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  pipeline.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  pipeline.stage.module = pass.module;
  pipeline.stage.pName = "main";
  pipeline.layout = pass.layout;
  return vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &pipeline, nullptr, &pass.pipeline) == VK_SUCCESS;
}

bool VulkanCompute::dispatch(std::uint32_t groups, Pass& pass) {
  auto pool = of_type<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  pool.queueFamilyIndex = family_;
  if (vkCreateCommandPool(device_, &pool, nullptr, &pass.commands) != VK_SUCCESS) return false;
  auto allocation = of_type<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  allocation.commandPool = pass.commands;
  allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocation.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  if (vkAllocateCommandBuffers(device_, &allocation, &commands) != VK_SUCCESS) return false;
  auto begin = of_type<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  if (vkBeginCommandBuffer(commands, &begin) != VK_SUCCESS) return false;
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pass.pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pass.layout, 0, 1, &pass.set, 0, nullptr);
  vkCmdDispatch(commands, groups, 1, 1);
  // The CPU reads here what a game's vertex shader would: VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT, at the vertex input.
  auto written = of_type<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &written, 0,
                       nullptr, 0, nullptr);
  auto submit = of_type<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  return vkEndCommandBuffer(commands) == VK_SUCCESS &&
         vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE) == VK_SUCCESS && vkQueueWaitIdle(queue_) == VK_SUCCESS;
}

bool VulkanCompute::run(const std::vector<std::uint32_t>& spirv, std::uint32_t groups,
                        std::vector<ComputeBuffer>& buffers) {
  Pass pass;
  const bool done = describe(buffers, pass) && build(spirv, pass) && dispatch(groups, pass);
  for (std::size_t i = 0; done && i < buffers.size(); ++i)
    if (!buffers[i].bytes.empty()) std::memcpy(buffers[i].bytes.data(), pass.buffers[i].bytes, buffers[i].bytes.size());
  destroy(pass);
  return done;
}

}  // namespace marrow::test
