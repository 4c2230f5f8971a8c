// Vulkan without a window: one compute shader over buffers in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>

namespace marrow::test {

// A buffer of descriptor set 0, at the binding of its place in the list. Empty: no such binding.
struct ComputeBuffer {
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  std::vector<std::byte> bytes;
};

class VulkanCompute {
 public:
  VulkanCompute() = default;
  ~VulkanCompute();
  VulkanCompute(const VulkanCompute&) = delete;
  VulkanCompute& operator=(const VulkanCompute&) = delete;

  // The first device of the first driver that is found, with the Khronos validation layer where that is installed.
  // False: there is none.
  bool open();
  const std::string& device_name() const { return name_; }
  bool validated() const { return validated_; }
  // What the validation layer has found fault with; it says so on stderr.
  unsigned complaints() const { return complaints_; }

  // Runs the module's main() once and reads all buffers back. False: a call has failed.
  bool run(const std::vector<std::uint32_t>& spirv, std::uint32_t groups, std::vector<ComputeBuffer>& buffers);

 private:
  struct Resident;
  struct Pass;
  void create_instance();
  bool create_device();
  bool create(const ComputeBuffer& from, Resident& out);
  void destroy(Pass& pass);
  bool describe(const std::vector<ComputeBuffer>& buffers, Pass& pass);
  bool build(const std::vector<std::uint32_t>& spirv, Pass& pass);
  bool dispatch(std::uint32_t groups, Pass& pass);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  std::string name_;
  bool validated_ = false;
  unsigned complaints_ = 0;
};

}  // namespace marrow::test
