// Contents: bytes of any length under their SHA-256 (program texts, place indexes, attachments). They are cut into
// chunks, so that a large one streams in and out; equal contents are kept once. One that nothing refers to is dropped
// when the store is opened the next time.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

inline constexpr std::size_t kChunkBytes = std::size_t{64} * 1024;

struct Content {
  std::string sha256;  // 64 hexadecimal digits, lower case
  std::uint64_t bytes = 0;
};

// Takes one content piece by piece. It belongs to one thread. Destroying it unfinished drops what it took.
class ContentWriter {
 public:
  ContentWriter() = default;
  ContentWriter(const ContentWriter&) = delete;
  ContentWriter& operator=(const ContentWriter&) = delete;
  virtual ~ContentWriter() = default;
  // Written in short transactions, at most 256 KiB in memory. Errors: disk_full, io_failed; after one, only destroy it.
  virtual Result<void> append(std::string_view bytes) = 0;
  // Seals the content. Nothing may follow.
  virtual Result<Content> finish() = 0;
};

// Reads one content again and again over hours, as a feed does. One thread at a time.
class ContentReader {
 public:
  ContentReader() = default;
  ContentReader(const ContentReader&) = delete;
  ContentReader& operator=(const ContentReader&) = delete;
  virtual ~ContentReader() = default;
  // As Contents::read().
  virtual Result<std::size_t> read(std::uint64_t offset, std::span<char> into) = 0;
};

class Contents : public Repository {
 public:
  virtual Result<std::unique_ptr<ContentWriter>> begin() = 0;
  // The whole in one call.
  virtual Result<Content> put(std::string_view bytes) = 0;
  // Of all contents.
  virtual Result<std::uint64_t> total_bytes() = 0;
  // Errors: not_found.
  virtual Result<Content> find(std::string_view sha256) = 0;
  // Bytes from `offset` on into `into`, as many as fit; 0 at the end. A call per chunk or more is cheap. Errors:
  // not_found.
  virtual Result<std::size_t> read(std::string_view sha256, std::uint64_t offset, std::span<char> into) = 0;
  // For a text that goes to a machine, all of it read and compared with its hash: where the store is not on this
  // computer's disks, a copy that is, so that no network has to answer while it is fed. It must not live longer than
  // the store. Errors: not_found, corrupt, disk_full, io_failed.
  virtual Result<std::shared_ptr<ContentReader>> reader(std::string_view sha256);
  // Reads all of it and compares the hash. Errors: not_found, corrupt.
  virtual Result<void> verify(std::string_view sha256) = 0;
};

// Reads in the store itself, whose reader() it is where the store is on this computer.
std::shared_ptr<ContentReader> read_in_place(Contents& contents, std::string_view sha256);

// The whole content; invalid_value when it is longer than `most`. For texts that are known to be small.
Result<std::string> read_whole(Contents& contents, std::string_view sha256, std::uint64_t most);

}  // namespace dripfeed::store
