#pragma once

#include "throng/standard.h"

namespace throng {

/// Success carries nothing.
struct Done {};

/// Says why something could not be done, in one sentence: it names the file, option or device, and what to do.
struct Error {
  std::string message;
};

namespace detail {
/// Ends the program, since there is nothing that a caller could go on with.
[[noreturn]] inline void end_without_value(const Error& error) {
  std::fprintf(stderr, "throng: the value of a Result that has none was asked for: %s\n", error.message.c_str());
  std::abort();
}
}  // namespace detail

/// A value, or the error that says why there is none. Nothing is thrown across a public interface.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// Where there is no value, the program prints the sentence of the error and ends. So do `*result` and `result->`.
  T& value() {
    if (!has_value()) detail::end_without_value(error());
    return *std::get_if<0>(&state_);
  }
  const T& value() const {
    if (!has_value()) detail::end_without_value(error());
    return *std::get_if<0>(&state_);
  }
  const Error& error() const {
    assert(!has_value());
    return *std::get_if<1>(&state_);
  }

  /// Converts to whether it went well, and if not, why.
  operator Result<Done>() const requires(!std::is_same_v<T, Done>) {
    return has_value() ? Result<Done>(Done{}) : Result<Done>(error());
  }

  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<T, Error> state_;
};

}  // namespace throng

// X11 has a macro of this name: a source that includes X11 before writes Result<Done>.
#if !defined(Status)
namespace throng {
using Status = Result<Done>;
}
#endif
