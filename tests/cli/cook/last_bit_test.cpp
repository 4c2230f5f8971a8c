// C libraries give sines, roots of three and powers that differ in the last bit: what is cooked does not depend on it.
#include <dlfcn.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "cli/support/cookings.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// How often which function was called.
std::map<std::string, long> calls_in(const std::string& path) {
  std::map<std::string, long> out;
  std::istringstream in(read_text(path));
  std::string name;
  for (long calls = 0; in >> name >> calls;) out[name] = calls;
  return out;
}

TEST(LastBit, TheShimMovesIt) {
  void* const shim = ::dlopen(last_bit_shim().c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(shim, nullptr) << ::dlerror();
  const auto sine = reinterpret_cast<double (*)(double)>(::dlsym(shim, "sin"));
  const auto power = reinterpret_cast<float (*)(float, float)>(::dlsym(shim, "powf"));
  ASSERT_TRUE(sine != nullptr && power != nullptr);
  int up = 0, down = 0;
  for (int i = 1; i <= 100; ++i) {
    const double x = i * 0.0625, want = std::sin(x), got = sine(x);
    EXPECT_TRUE(got == std::nextafter(want, 2.0) || got == std::nextafter(want, -2.0)) << x;
    EXPECT_EQ(got, sine(x));
    ++(got > want ? up : down);
  }
  EXPECT_GT(up, 20);
  EXPECT_GT(down, 20);
  EXPECT_NE(power(3.0f, 0.5f), std::pow(3.0f, 0.5f));
  EXPECT_EQ(sine(0), 0);
  ::dlclose(shim);
}

// The cooker calls none of them. Draco calls log2, to choose between ways to store a mesh.
TEST(LastBit, DecidesNothing) {
  const TemporaryFolder folder;
  long by_draco = 0;
  for (const Cooking& cooking : cookings(folder)) {
    SCOPED_TRACE(cooking.name);
    const std::string plain = folder / "plain.mrw", moved = folder / "moved.mrw", calls = folder / "calls";
    ASSERT_EQ(run_program(cook_command(cooking, plain)).code, 0);
    write_text(calls, "unwritten 1\n");
    const Ran ran =
        run_program(cook_command(cooking, moved, {"LD_PRELOAD=" + last_bit_shim(), "MARROW_LAST_BIT=" + calls}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(read_text(plain) == read_text(moved));
    for (const auto& [name, count] : calls_in(calls)) {
      EXPECT_EQ(name, "log2") << count << " calls";
      by_draco += count;
    }
  }
  EXPECT_GT(by_draco, 250) << "the library was not asked";
}

}  // namespace
}  // namespace marrow::test
