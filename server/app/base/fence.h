// A named fence: what a library throws inside it (no memory, a system call that failed) ends the piece of work and not
// the process, in which lines may be in the middle of a block. What is thrown is logged with the fence's name.
#pragma once

#include <exception>
#include <string_view>
#include <utility>

#include <spdlog/spdlog.h>

namespace dripfeed::app {

// Whether `work` came to its end.
template <class F>
bool fenced(std::string_view name, F&& work) noexcept {
  try {
    std::forward<F>(work)();
    return true;
  } catch (const std::exception& error) {
    try {
      spdlog::error("{}: {}", name, error.what());
    } catch (const std::exception&) {
      return false;  // no memory for the log either; the caller goes on
    }
    return false;
  }
}

}  // namespace dripfeed::app
