// TLS 1.2 and 1.3 with OpenSSL's own choice of ciphers.
#include "server/http/tls.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <openssl/ssl.h>
#include <spdlog/spdlog.h>

namespace dripfeed::http {

namespace {

namespace ssl = boost::asio::ssl;

std::filesystem::file_time_type time_of(const std::string& path) {
  std::error_code unknown;  // what is not there has no time: it differs once it comes
  const auto time = std::filesystem::last_write_time(path, unknown);
  return unknown ? std::filesystem::file_time_type::min() : time;
}

}  // namespace

TlsFiles::Stamp TlsFiles::stamp() const { return {.certificate = time_of(certificate_), .key = time_of(key_)}; }

std::expected<TlsFiles::Context, std::string> TlsFiles::read() const {
  auto context = std::make_shared<ssl::context>(ssl::context::tls_server);
  context->set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 | ssl::context::no_sslv3 |
                       ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1);
  SSL_CTX_set_mode(context->native_handle(), SSL_MODE_RELEASE_BUFFERS);  // 34 KB less for each idle connection
  boost::system::error_code error;
  context->use_certificate_chain_file(certificate_, error);
  if (error) return std::unexpected(fmt::format("{} is not a certificate in PEM: {}", certificate_, error.message()));
  context->use_private_key_file(key_, ssl::context::pem, error);
  if (error)
    return std::unexpected(fmt::format("{} is not a key in PEM for {}: {}", key_, certificate_, error.message()));
  return context;
}

std::expected<TlsFiles, std::string> TlsFiles::open(std::string certificate, std::string key) {
  TlsFiles files(std::move(certificate), std::move(key));
  auto context = files.read();
  if (!context) return std::unexpected(context.error());
  files.context_ = std::move(*context);
  return files;
}

void TlsFiles::refresh() {
  const Stamp now = stamp();
  if (now == stamp_) return;
  stamp_ = now;
  auto context = read();
  if (!context) {
    spdlog::warn("the certificate was not renewed, the previous one stays in use: {}", context.error());
    return;
  }
  context_ = std::move(*context);
  spdlog::info("the certificate {} was read again", certificate_);
}

}  // namespace dripfeed::http
