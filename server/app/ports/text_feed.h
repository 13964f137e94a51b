// What a peer is sent that connects to read lines of text. One for each peer; used on the thread of its listener alone.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace dripfeed::app {

class TextFeed {
 public:
  TextFeed() = default;
  TextFeed(const TextFeed&) = delete;
  TextFeed& operator=(const TextFeed&) = delete;
  virtual ~TextFeed() = default;
  // Lines with their ends: when it has connected, what is new since the last call, and in answer to a line of its own.
  // "": nothing.
  virtual std::string greeting() = 0;
  virtual std::string changes() = 0;
  virtual std::string answer(std::string_view line) = 0;
};

using MakeTextFeed = std::function<std::unique_ptr<TextFeed>()>;

}  // namespace dripfeed::app
