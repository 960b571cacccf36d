#pragma once

#include <cstddef>
#include <string>

namespace coherency {

/// Counts, while it lives, the calls of malloc() and its kin, operator new among them, by who asked: the
/// nearest caller that is not the C or C++ library or fmt. This program's are ours; what the graphics driver
/// allocates for itself is its own affair. One at a time. In this program only: AllocationCount.cpp has a
/// malloc() in place of the C library's.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;

  std::size_t ours() const;
  std::size_t others() const;
  /// Callers of the first of ours, innermost first, a line each, for `addr2line -Cfie PROGRAM OFFSET`; empty
  /// where there was none.
  std::string first() const;
};

}  // namespace coherency
