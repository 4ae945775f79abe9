// 64-bit hash of plain data: FNV-1a (Fowler, Noll & Vo) over 8-byte words, mixed once more.
#pragma once
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

#include "pmr/base/random.hpp"

namespace pmr {

class Hash {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void add(const T& value) { bytes(&value, sizeof(T)); }
  template <class T>
  void add(std::span<const T> values) {
    bytes(values.data(), values.size_bytes());
  }
  void add(std::string_view text) { bytes(text.data(), text.size()); }
  void bytes(const void* data, std::size_t size) {
    const auto* p = static_cast<const unsigned char*>(data);
    for (; size >= 8; p += 8, size -= 8) word(p, 8);
    if (size > 0) word(p, size);
  }
  std::uint64_t value() const { return mix64(state_); }

 private:
  void word(const unsigned char* p, std::size_t size) {
    std::uint64_t w = 0;
    std::memcpy(&w, p, size);
    state_ = (state_ ^ w) * 0x100000001b3ULL;
    state_ ^= state_ >> 29;  // FNV alone never moves high bits down
  }
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace pmr
