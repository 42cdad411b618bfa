// SPDX-License-Identifier: Apache-2.0
// What compiled C++ calls to throw and catch, and to end a thread. Debian's libc++abi for WebAssembly comes without it.
//
// The tables are those of the Itanium C++ ABI (LSDA) as LLVM writes them for WebAssembly. One thread, and classes with one
// base at most: core throws nothing else. On WebAssembly destructors return their object; another signature would trap.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <typeinfo>

// Type information as the ABI has it (2.9.5).
namespace __cxxabiv1 {
class __attribute__((visibility("default"))) __class_type_info : public std::type_info {
 public:
  ~__class_type_info() override;
};
class __attribute__((visibility("default"))) __si_class_type_info : public __class_type_info {
 public:
  ~__si_class_type_info() override;
  const __class_type_info* __base_type;
};
}  // namespace __cxxabiv1

namespace {

// Stands before the object that is thrown.
struct Header {
  const std::type_info* type;
  void* (*destroy)(void*);
  int handlers;      // how many handlers hold it; negative while it is thrown again
  Header* previous;  // caught before this one and not yet left
};
constexpr std::size_t kRoom = (sizeof(Header) + 15) / 16 * 16;

Header* innermost = nullptr;

Header* header_of(void* object) {
  return reinterpret_cast<Header*>(static_cast<char*>(object) - kRoom);
}
void* object_of(Header* header) { return reinterpret_cast<char*>(header) + kRoom; }

// Reads the numbers of a table, one after the other.
struct Reader {
  const std::uint8_t* at;

  std::uint32_t count() {
    std::uint32_t value = 0;
    for (int shift = 0;; shift += 7) {
      const std::uint8_t byte = *at++;
      value |= static_cast<std::uint32_t>(byte & 0x7fU) << shift;
      if ((byte & 0x80U) == 0) return value;
    }
  }
  std::int32_t number() {
    std::uint32_t value = 0;
    for (int shift = 0;;) {
      const std::uint8_t byte = *at++;
      value |= static_cast<std::uint32_t>(byte & 0x7fU) << shift;
      shift += 7;
      if ((byte & 0x80U) != 0) continue;
      if (shift < 32 && (byte & 0x40U) != 0) value |= ~0U << shift;
      return static_cast<std::int32_t>(value);
    }
  }
};

bool catches(const std::type_info* wanted, const std::type_info* thrown) {
  while (thrown != nullptr) {
    if (*wanted == *thrown) return true;
    const auto* single = dynamic_cast<const __cxxabiv1::__si_class_type_info*>(thrown);
    thrown = single != nullptr ? single->__base_type : nullptr;
  }
  return false;
}

// The first handler in a list of actions that takes what was thrown; 0 if none does.
std::uint32_t handler_in(const std::uint8_t* action, const std::uint32_t* types,
                         const std::type_info* thrown) {
  while (true) {
    Reader reader{action};
    const std::int32_t which = reader.number();
    const std::uint8_t* link = reader.at;
    const std::int32_t next = reader.number();
    if (which > 0) {
      const auto* wanted = reinterpret_cast<const std::type_info*>(types[-which]);
      if (wanted == nullptr || catches(wanted, thrown)) return static_cast<std::uint32_t>(which);
    }
    if (next == 0) return 0;
    action = link + next;
  }
}

}  // namespace

extern "C" {

// Written by compiled code before it calls the personality routine, which answers in `selector`.
struct LandingPad {
  std::uint32_t index;
  const std::uint8_t* table;
  std::uint32_t selector;
};
LandingPad __wasm_lpad_context = {};

void* __cxa_allocate_exception(std::size_t size) {
  void* room = std::malloc(kRoom + size);
  if (room == nullptr) __builtin_trap();
  auto* header = static_cast<Header*>(room);
  *header = Header{};
  return object_of(header);
}

void __cxa_free_exception(void* object) { std::free(header_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  header_of(object)->type = type;
  header_of(object)->destroy = destroy;
  __builtin_wasm_throw(0, object);
}

void* __cxa_get_exception_ptr(void* object) { return object; }

void* __cxa_begin_catch(void* object) {
  Header* header = header_of(object);
  if (header->handlers < 0) header->handlers = -header->handlers;
  ++header->handlers;
  if (innermost != header) {
    header->previous = innermost;
    innermost = header;
  }
  return object;
}

void __cxa_end_catch() {
  Header* header = innermost;
  if (header == nullptr) return;
  if (header->handlers < 0) {  // thrown again: it lives on
    if (++header->handlers == 0) innermost = header->previous;
    return;
  }
  if (--header->handlers > 0) return;
  innermost = header->previous;
  if (header->destroy != nullptr) header->destroy(object_of(header));
  std::free(header);
}

[[noreturn]] void __cxa_rethrow() {
  if (innermost == nullptr) __builtin_trap();
  innermost->handlers = -innermost->handlers;
  __builtin_wasm_throw(0, object_of(innermost));
}

int _Unwind_CallPersonality(void* object) {
  __wasm_lpad_context.selector = 0;
  if (__wasm_lpad_context.table == nullptr) return 0;
  Reader reader{__wasm_lpad_context.table};
  constexpr std::uint8_t kOmitted = 0xff;
  if (*reader.at++ != kOmitted) __builtin_trap();  // landing pads count from the function
  const std::uint32_t* types = nullptr;
  if (*reader.at++ != kOmitted) {
    const std::uint32_t offset = reader.count();
    types = reinterpret_cast<const std::uint32_t*>(reader.at + offset);
  }
  ++reader.at;  // encoding of the call sites
  const std::uint32_t length = reader.count();
  const std::uint8_t* actions = reader.at + length;
  for (std::uint32_t site = 0; reader.at < actions; ++site) {
    reader.count();
    const std::uint32_t action = reader.count();
    if (site != __wasm_lpad_context.index) continue;
    if (action != 0)
      __wasm_lpad_context.selector =
          handler_in(actions + action - 1, types, header_of(object)->type);
    return 0;
  }
  __builtin_trap();
}

// The only thread ends with the page.
int __cxa_thread_atexit(void (* /*destroy*/)(void*), void* /*object*/, void* /*library*/) {
  return 0;
}

int __gxx_wasm_personality_v0() { return 0; }  // only its address is taken
void _Unwind_DeleteException(void* /*exception*/) {}
}
