#include "tests/render/AllocationCount.h"

#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <execinfo.h>
#include <link.h>
#include <unwind.h>

// What the C library's own functions are called beside their standard names.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}
// NOLINTEND(bugprone-reserved-identifier)

namespace coherency {
namespace {

using Address = std::uintptr_t;

enum class Owner { Ours, Library, Others };

/// Where a loaded file's code lies.
struct Code {
  Address begin;
  Address end;
  Owner owner;
};

std::atomic<bool> counting = false;
std::atomic<std::size_t> our_calls = 0;
std::atomic<std::size_t> other_calls = 0;
thread_local bool looking = false;  // what looking up a caller allocates is not counted
std::array<Code, 32> code;
std::size_t code_count = 0;
std::array<void*, 24> first_callers;
int first_depth = 0;

Owner ownerOf(std::string_view file) {
  if (file.empty()) return Owner::Ours;  // the program itself has no name
  for (const std::string_view library :
       {"/libc.so", "/libstdc++.so", "/libgcc_s.so", "/libm.so", "/libfmt.so"})
    if (file.find(library) != std::string_view::npos) return Owner::Library;
  return Owner::Others;
}

int addCode(dl_phdr_info* file, std::size_t /*size*/, void* /*unused*/) {
  const Owner owner = ownerOf(file->dlpi_name);
  if (owner == Owner::Others) return 0;
  for (int i = 0; i < file->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = file->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
    const Address begin = file->dlpi_addr + segment.p_vaddr;
    code.at(code_count++) = {begin, begin + segment.p_memsz, owner};
  }
  return 0;
}

Owner ownerOf(Address address) {
  for (std::size_t i = 0; i < code_count; ++i)
    if (address >= code[i].begin && address < code[i].end) return code[i].owner;
  return Owner::Others;
}

/// Walks outward from the function that allocates.
struct Walk {
  Address asker;  // returned to by malloc(); what is within it is this file
  bool begun = false;
  Owner owner = Owner::Others;
};

_Unwind_Reason_Code step(_Unwind_Context* context, void* data) {
  Walk& walk = *static_cast<Walk*>(data);
  const Address address = _Unwind_GetIP(context);
  walk.begun = walk.begun || address == walk.asker;
  if (!walk.begun) return _URC_NO_REASON;
  walk.owner = ownerOf(address);
  return walk.owner == Owner::Library ? _URC_NO_REASON : _URC_END_OF_STACK;
}

void note(void* return_address) {
  if (!counting || looking) return;
  looking = true;
  Walk walk{reinterpret_cast<Address>(return_address)};
  walk.owner = ownerOf(walk.asker);
  if (walk.owner == Owner::Library) _Unwind_Backtrace(step, &walk);
  if (walk.owner != Owner::Ours)
    ++other_calls;
  else if (our_calls++ == 0)
    first_depth = backtrace(first_callers.data(), static_cast<int>(first_callers.size()));
  looking = false;
}

}  // namespace

AllocationCount::AllocationCount() {
  assert(!counting);
  code_count = 0;
  dl_iterate_phdr(addCode, nullptr);
  our_calls = other_calls = 0;
  first_depth = 0;
  counting = true;
}

AllocationCount::~AllocationCount() {
  counting = false;
}

std::size_t AllocationCount::ours() const {
  return our_calls;
}

std::size_t AllocationCount::others() const {
  return other_calls;
}

std::string AllocationCount::first() const {
  looking = true;
  char** names = backtrace_symbols(first_callers.data(), first_depth);
  std::string text;
  for (int i = 0; i < first_depth; ++i) text += std::string("  ") + names[i] + "\n";
  std::free(names);
  looking = false;
  return text;
}

}  // namespace coherency

extern "C" {

void* malloc(std::size_t size) noexcept {
  coherency::note(__builtin_return_address(0));
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  coherency::note(__builtin_return_address(0));
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  coherency::note(__builtin_return_address(0));
  return __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  coherency::note(__builtin_return_address(0));
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** made, std::size_t alignment, std::size_t size) noexcept {
  coherency::note(__builtin_return_address(0));
  *made = __libc_memalign(alignment, size);
  return *made == nullptr ? ENOMEM : 0;
}

}  // extern "C"
