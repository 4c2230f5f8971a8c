// What `marrow bench` times allocates nothing and does the same however its iterations are cut up.
#include "bench/workload.h"

#include <gtest/gtest.h>

#include "support/allocations.h"

namespace marrow::tools {
namespace {

// Rows that need no more than the sample, smaller meshes only.
std::vector<Row> own_rows(Models& models) {
  std::vector<Row> rows;
  for (const RowGroup& group : {sampling_rows(), pose_rows(models), skinning_rows(), reaching_rows(), chain_rows(),
                                limit_rows(), following_rows()}) {
    for (const Row& row : group.rows) {
      if (row.model == &kNewt ? row.name.ends_with("newt_twist") || row.name.ends_with("newt_reach")
                              : row.model != nullptr || row.name.ends_with("0000"))
        continue;  // those two take long to cook
      rows.push_back(row);
      for (const std::string& clip : row.clips) models.want(*row.model, clip);
    }
  }
  return rows;
}

TEST(BenchWorkloads, AllocateNothingAndGoOnWhereTheyStopped) {
  Models models;
  const std::vector<Row> rows = own_rows(models);
  for (const Row& row : rows) {
    const std::unique_ptr<Workload> once = row.make(models), twice = row.make(models);
    const std::size_t before = test::allocation_count();
    once->run(5);
    twice->run(2);
    twice->run(3);
    const std::uint64_t hash = once->hash_output(1), other = twice->hash_output(1), start = once->hash_output(2);
    EXPECT_EQ(test::allocation_count(), before) << row.name;
    EXPECT_EQ(hash, other) << row.name;
    EXPECT_NE(hash, start) << row.name;
  }
  EXPECT_GE(rows.size(),
            56u);  // 8 of clips, 45 of meshes, 3 of inverse kinematics; 8 of poses where the sample stands in
}

}  // namespace
}  // namespace marrow::tools
