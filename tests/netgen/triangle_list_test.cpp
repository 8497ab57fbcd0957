#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "netgen/nets/refine.h"

namespace epsnet::triangle_list_test {
namespace {

using testing::ElementsAre;

template <class List>
std::vector<std::uint32_t> emptied(List& list) {
  std::vector<std::uint32_t> result;
  while (list.size() > 0) {
    result.push_back(list.pop().number());
  }
  return result;
}

TEST(TriangleList, QueueGivesTheOldestFirstWhileItGrows) {
  TriangleQueue queue;
  std::array<TriangleId, 700> block{};
  std::uint32_t next_in = 0;
  std::uint32_t next_out = 0;
  for (int round = 0; round < 20; ++round) {
    for (TriangleId& t : block) t = TriangleId(next_in++);
    queue.push(block);
    ASSERT_EQ(queue[0].number(), next_out);
    ASSERT_EQ(queue[queue.size() - 1].number(), next_in - 1);
    for (int i = 0; i < 300; ++i) {
      ASSERT_EQ(queue.pop().number(), next_out++);
    }
  }
  const std::vector<std::uint32_t> rest = emptied(queue);
  ASSERT_EQ(rest.size(), next_in - next_out);
  EXPECT_EQ(rest.front(), next_out);
  EXPECT_EQ(rest.back(), next_in - 1);
}

TEST(TriangleList, StackGivesTheNewestFirst) {
  TriangleStack stack;
  stack.push(std::array{TriangleId(1), TriangleId(2)});
  stack.push(std::array{TriangleId(3)});
  EXPECT_EQ(stack.pop(), TriangleId(3));
  stack.push(std::array{TriangleId(2)});
  EXPECT_THAT(emptied(stack), ElementsAre(2, 2, 1));
}

TEST(TriangleList, HeapGivesTheLargestFirst) {
  TriangleHeap heap;
  heap.push(TriangleId(7), 0.5);
  heap.push(TriangleId(9), 2);
  heap.push(TriangleId(8), 2);
  heap.push(TriangleId(1), 1);
  EXPECT_THAT(emptied(heap), ElementsAre(8, 9, 1, 7));
}

}  // namespace
}  // namespace epsnet::triangle_list_test
