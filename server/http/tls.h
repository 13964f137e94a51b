// The server's own TLS: a context from two PEM files, read again when they change. Connections that are open keep the
// context that they began with.
#pragma once

#include <expected>
#include <filesystem>
#include <memory>
#include <string>

#include <boost/asio/ssl/context.hpp>

namespace dripfeed::http {

class TlsFiles {
 public:
  using Context = std::shared_ptr<boost::asio::ssl::context>;

  // Reads both; or one sentence that names the file and says what is wrong with it.
  static std::expected<TlsFiles, std::string> open(std::string certificate, std::string key);
  // The newest that could be read.
  [[nodiscard]] const Context& context() const { return context_; }
  // Looks whether a file has changed since, and reads both again. A pair that does not fit (one is written, the other
  // not yet) is logged once, and looked at again with the next change.
  void refresh();

 private:
  struct Stamp {
    std::filesystem::file_time_type certificate;
    std::filesystem::file_time_type key;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  TlsFiles(std::string certificate, std::string key)
      : certificate_(std::move(certificate)), key_(std::move(key)), stamp_(stamp()) {}
  [[nodiscard]] Stamp stamp() const;
  [[nodiscard]] std::expected<Context, std::string> read() const;

  std::string certificate_;
  std::string key_;
  Stamp stamp_;
  Context context_;
};

}  // namespace dripfeed::http
