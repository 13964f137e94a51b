// The contents of a store that is on another computer: all as there, but a text that is fed is copied to this disk.
#pragma once

#include <string>

#include "store/contents.h"

namespace dripfeed::journal {

class LocalContents final : public store::Contents {
 public:
  // The copies are files without a name in `folder`: they are gone when no feed has them, and after a crash.
  LocalContents(store::Contents& there, std::string folder) : there_(there), folder_(std::move(folder)) {}
  store::Result<std::unique_ptr<store::ContentWriter>> begin() override { return there_.begin(); }
  store::Result<store::Content> put(std::string_view bytes) override { return there_.put(bytes); }
  store::Result<store::Content> find(std::string_view sha256) override { return there_.find(sha256); }
  store::Result<std::size_t> read(std::string_view sha256, std::uint64_t offset, std::span<char> into) override {
    return there_.read(sha256, offset, into);
  }
  store::Result<std::shared_ptr<store::ContentReader>> reader(std::string_view sha256) override;
  store::Result<void> verify(std::string_view sha256) override { return there_.verify(sha256); }
  store::Result<std::uint64_t> total_bytes() override { return there_.total_bytes(); }

 private:
  store::Contents& there_;
  std::string folder_;
};

}  // namespace dripfeed::journal
