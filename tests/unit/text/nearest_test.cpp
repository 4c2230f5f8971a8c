// What is meant by a name that does not exist.
#include "text/nearest.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

using Names = std::vector<std::string>;

TEST(Nearest, EditDistance) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("walk", "walk"), 0u);
  EXPECT_EQ(edit_distance("wlk", "walk"), 1u);         // one more
  EXPECT_EQ(edit_distance("walks", "walk"), 1u);       // one less
  EXPECT_EQ(edit_distance("wakk", "walk"), 1u);        // one other
  EXPECT_EQ(edit_distance("wlak", "walk"), 2u);        // two exchanged
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);   // k → s, e → i, and g
  EXPECT_EQ(edit_distance("sunday", "saturday"), 3u);  // a, t, and n → r
  EXPECT_EQ(edit_distance("abc", "xyz"), 3u);
}

TEST(Nearest, Name) {
  const Names names = {"idle", "walk", "run", "Armature|jump_high", "mixamorig:LeftHandIndex1", "mixamorig:LeftHand"};
  EXPECT_EQ(nearest_name("wlak", names), "walk");
  EXPECT_EQ(nearest_name("WALK", names), "walk") << "case does not count";
  EXPECT_EQ(nearest_name("sunk", {"walk", "bunker"}), "") << "3 edits of 4 letters, 3 of 6";
  EXPECT_EQ(nearest_name("sunker", {"walk", "bunker"}), "bunker");
  EXPECT_EQ(nearest_name("lefthand", names), "mixamorig:LeftHand") << "the shortest that it is a part of";
  EXPECT_EQ(nearest_name("jump", names), "Armature|jump_high");
  EXPECT_EQ(nearest_name("nn", {"bone_nn"}), "") << "two letters are part of too many names";
  EXPECT_EQ(nearest_name("2", {"up"}), "") << "nothing is alike";
  EXPECT_EQ(nearest_name("wave", {"wove", "wive"}), "wove") << "of equals the first";
  EXPECT_EQ(nearest_name("fade", {"base", "fade_in"}), "fade_in") << "two edits of four letters, and a begin";
  EXPECT_EQ(nearest_name("jump", {"jumps", "jump_high"}), "jumps") << "one edit";
  EXPECT_EQ(nearest_name("wave", {}), "");
}

TEST(Nearest, Listed) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a", "b", "a"}), "a, b");
  Names many;
  for (int i = 1; i <= 12; ++i) many.push_back("n" + std::to_string(i));
  EXPECT_EQ(listed(many), "n1, n2, n3, n4, n5, n6, n7, n8, n9, n10, n11, n12");
  many.insert(many.end(), {"n13", "n14", "n1"});
  EXPECT_EQ(listed(many), "n1, n2, n3, n4, n5, n6, n7, n8, n9, n10, n11, n12 and 2 more");
}

TEST(Nearest, Suggestion) {
  EXPECT_EQ(suggestion("wlak", {"idle", "walk"}), "did you mean \"walk\"? there are \"idle\", \"walk\"");
  EXPECT_EQ(suggestion("somersault", {"idle", "walk"}), "there are \"idle\", \"walk\"");
  EXPECT_EQ(suggestion("walk", {}), "");
}

}  // namespace
}  // namespace marrow::tools
