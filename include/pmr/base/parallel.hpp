// The one mechanism for threads (oneTBB, hidden in parallel.cpp). Work is cut into blocks of fixed
// size, whatever the number of threads, and sums are taken block by block in order: same bits on
// any number of threads.
#pragma once
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace pmr {

inline constexpr std::size_t block_size = 1024;  // [items] of one block

// Limits the process to n threads for as long as the value lives; n = 0 means all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(int n);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  static int current();  // threads that parallel loops may use now [1]

 private:
  void* control_;
};

// Calls body(first, last) over [0, count) in blocks; blocks may run concurrently, in any order.
void parallel_blocks(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body,
                     std::size_t block = block_size);

// Calls body(i) for i in [0, count).
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t block = block_size) {
  parallel_blocks(
      count,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) body(i);
      },
      block);
}

// zero + the sum over i of term(i), with the same bits on any number of threads.
template <class Value, class Term>
Value parallel_sum(std::size_t count, const Value& zero, const Term& term) {
  std::vector<Value> partial((count + block_size - 1) / block_size, zero);
  parallel_blocks(count, [&](std::size_t first, std::size_t last) {
    Value sum = zero;
    for (std::size_t i = first; i < last; ++i) sum += term(i);
    partial[first / block_size] = sum;
  });
  Value total = zero;
  for (const Value& p : partial) total += p;
  return total;
}
template <class Term>
double parallel_sum(std::size_t count, const Term& term) {
  return parallel_sum(count, 0.0, term);
}

// `bins` sums to which add(i, sums) adds what item i has to say, with the same bits on any number
// of threads.
template <class Add>
std::vector<double> parallel_bins(std::size_t count, std::size_t bins, const Add& add) {
  std::vector<double> total(bins, 0.0);
  std::vector<std::vector<double>> partial((count + block_size - 1) / block_size);
  parallel_blocks(count, [&](std::size_t first, std::size_t last) {
    std::vector<double> sums(bins, 0.0);
    for (std::size_t i = first; i < last; ++i) add(i, sums);
    partial[first / block_size] = std::move(sums);
  });
  for (const std::vector<double>& p : partial)
    for (std::size_t k = 0; k < bins; ++k) total[k] += p[k];
  return total;
}

// Largest term(i), at least `floor`.
template <class Term>
double parallel_max(std::size_t count, double floor, const Term& term) {
  std::vector<double> partial((count + block_size - 1) / block_size, floor);
  parallel_blocks(count, [&](std::size_t first, std::size_t last) {
    double largest = floor;
    for (std::size_t i = first; i < last; ++i) {
      const double value = term(i);
      if (value > largest) largest = value;
    }
    partial[first / block_size] = largest;
  });
  for (const double p : partial) floor = p > floor ? p : floor;
  return floor;
}

}  // namespace pmr
