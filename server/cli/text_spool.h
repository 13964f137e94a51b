// A temporary file for a long text that is written before it is known whether it is wanted. It has no name, and goes
// with the command.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/render/streamed_render.h"

namespace dripfeed::cli {

class TextSpool final : public compile::TextSink {
 public:
  void write(std::string_view text) override;
  // `text` with its splices to `path` ("" or "-": standard output). False, with a message, when it cannot.
  bool write_output(const std::string& path, std::string_view text, const std::vector<compile::Splice>& splices);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  bool copy(const compile::Splice& splice, std::FILE* to);
  void fail();

  std::unique_ptr<std::FILE, Close> file_;
  std::string fault_;  // once something could not be written
};

}  // namespace dripfeed::cli
