// The server on loopback with handlers of a test: what they throw, and answers that cannot be sent, end one connection;
// what is slow in one lane holds up no other; a stop has an end.
#include "server/http/server.h"

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace dripfeed::http {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// One connection of a client.
class Link {
 public:
  explicit Link(std::uint16_t port) : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval most{.tv_sec = 20, .tv_usec = 0};
    ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof(most));
    // The socket interface takes every address by this type.
    EXPECT_EQ(::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link() { ::close(descriptor_); }

  void send_text(std::string_view text) const {
    EXPECT_EQ(::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  // All that comes up to `end`, or until the server closes.
  [[nodiscard]] std::string hear(std::string_view end) const {
    std::string got;
    std::string piece(65536, '\0');
    while (got.find(end) == std::string::npos) {
      const ssize_t count = ::recv(descriptor_, piece.data(), piece.size(), 0);
      if (count <= 0) break;
      got.append(piece, 0, static_cast<std::size_t>(count));
    }
    return got;
  }

 private:
  int descriptor_;
};

std::string get(std::string_view path) { return "GET " + std::string(path) + " HTTP/1.1\r\nHost: x\r\n\r\n"; }

constexpr unsigned kHeavyThreads = 20;

Response text_response(std::string body) {
  Response response;
  response.body = std::move(body);
  return response;
}

Response faulty(const Request& request) {
  if (request.path[0] == "throw") throw std::runtime_error("a fault of a handler");
  Response response = text_response("fine.");
  if (request.path[0] == "long") response.headers.emplace_back("Location", "/" + std::string(70'000, 'a'));
  if (request.path[0] == "split") response.headers.emplace_back("Location", "/a\r\nSet-Cookie: x=y");
  if (request.path[0] == "source") {
    response.source = [](std::span<char>) -> std::expected<std::size_t, std::string> {
      throw std::runtime_error("a fault of a source");
    };
  }
  return response;
}

std::unique_ptr<Server> start(Answerer answerer) {
  if (!answerer.refuse_long) answerer.refuse_long = [](const Request&) { return std::nullopt; };
  if (!answerer.plan) {
    answerer.plan = [](const Request& request) {
      const std::string& first = request.path[0];
      return Plan{.lane = first == "command" ? Lane::command
                          : first == "write" ? Lane::write
                          : first == "bulk"  ? Lane::bulk
                          : first == "heavy" ? Lane::heavy
                                             : Lane::here,
                  .body_limit_bytes = kLargeBody_bytes};
    };
  }
  ServerSettings settings;
  settings.address.port = 0;
  settings.heavy_threads = kHeavyThreads;
  auto server = Server::start(settings, std::move(answerer));
  EXPECT_TRUE(server) << server.error();
  return std::move(*server);
}

TEST(HttpServer, AFaultOfAHandlerEndsItsConnectionAlone) {
  for (const char* lane : {"", "command/", "bulk/", "heavy/"}) {
    const auto server = start({.plan = {}, .refuse_long = {}, .answer = [](const Request& request) {
                                 Request inner = request;
                                 if (inner.path.size() > 1) inner.path.erase(inner.path.begin());
                                 return faulty(inner);
                               }});
    for (const char* path : {"throw", "long", "split", "source"}) {
      const Link other(server->port());
      other.send_text(get("/fine"));
      EXPECT_NE(other.hear("fine.").find("200 OK"), std::string::npos);
      if (*lane == '\0' || std::string_view(path) != "throw") {  // a thrown one in a lane answers nothing
        const Link link(server->port());
        link.send_text(get("/" + std::string(lane) + path));
        const std::string got = link.hear("cannot be sent");
        EXPECT_EQ(got.find("Set-Cookie"), std::string::npos) << got;
        if (std::string_view(path) == "long" || std::string_view(path) == "split") {
          EXPECT_EQ(got.find("HTTP/1.1 500"), 0U) << path << " " << got.substr(0, 100);
        }
      } else {
        const Link link(server->port());
        link.send_text(get("/" + std::string(lane) + path));
      }
      other.send_text(get("/fine"));
      EXPECT_NE(other.hear("fine.").find("200 OK"), std::string::npos) << "after " << lane << path;
    }
  }
}

TEST(HttpServer, WhatIsSlowHoldsUpNothingElse) {
  std::promise<void> go;
  const std::shared_future<void> gone = go.get_future().share();
  const auto server = start({.plan = {}, .refuse_long = {}, .answer = [gone](const Request& request) {
                               if (request.path.size() > 1) gone.wait();
                               return text_response("done.");
                             }});
  std::vector<std::unique_ptr<Link>> slow;
  for (const char* lane : {"bulk", "heavy", "write"}) {
    for (int i = 0; i < 20; ++i) {
      slow.push_back(std::make_unique<Link>(server->port()));
      slow.back()->send_text(get("/" + std::string(lane) + "/slow"));
    }
  }
  for (int i = 0; i < 20; ++i) {
    for (const char* path : {"/command", "/read"}) {
      const auto begin = Clock::now();
      const Link link(server->port());
      link.send_text(get(path));
      EXPECT_NE(link.hear("done.").find("done."), std::string::npos);
      EXPECT_LT(Clock::now() - begin, 5s);
    }
  }
  go.set_value();
  for (const auto& link : slow) EXPECT_NE(link->hear("done.").find("done."), std::string::npos);
}

// Which of them are sent away depends on how soon the lane's threads take the first ones; how many, does not.
TEST(HttpServer, ALaneThatIsFullAsksToComeAgain) {
  constexpr int kAll = 100;
  std::promise<void> go;
  const std::shared_future<void> gone = go.get_future().share();
  const auto server = start({.plan = {}, .refuse_long = {}, .answer = [gone](const Request& request) {
                               if (request.target == "/heavy") gone.wait();
                               return text_response("done.");
                             }});
  std::vector<std::unique_ptr<Link>> links;
  for (int i = 0; i < kAll; ++i) {
    links.push_back(std::make_unique<Link>(server->port()));
    links.back()->send_text(get("/heavy"));
  }
  const Link later(server->port());
  later.send_text(get("/here"));  // by its answer all before it were read
  ASSERT_EQ(later.hear("done.").find("HTTP/1.1 200"), 0U);
  go.set_value();
  int sent_away = 0;
  for (const auto& link : links) {
    const std::string answer = link->hear("\r\n\r\n");
    if (answer.find("HTTP/1.1 503") != 0U) continue;
    ++sent_away;
    EXPECT_NE(answer.find("Retry-After: 1"), std::string::npos) << answer;
  }
  EXPECT_GE(sent_away, kAll - static_cast<int>(kHeavyThreads) - 32) << "at work, and 32 that wait";
  EXPECT_LE(sent_away, kAll - 32);
}

TEST(HttpServer, AStopDoesNotWaitForEverForARequest) {
  std::promise<void> go;
  const std::shared_future<void> gone = go.get_future().share();
  std::promise<void> begun;
  const auto server = start({.plan = {}, .refuse_long = {}, .answer = [&begun, gone](const Request&) {
                               begun.set_value();
                               gone.wait();
                               return text_response("done.");
                             }});
  const Link link(server->port());
  link.send_text(get("/heavy"));
  begun.get_future().wait();
  const auto begin = Clock::now();
  EXPECT_FALSE(server->stop(300ms));
  EXPECT_LT(Clock::now() - begin, 5s);
  EXPECT_EQ(link.hear("never"), "") << "its connection is closed";
  go.set_value();
  EXPECT_TRUE(server->stop(10s));
}

// The oldest that says nothing goes; whoever asks is answered.
TEST(HttpServer, ManyWhoSayNothingKeepNoOneOut) {
  const auto server =
      start({.plan = {}, .refuse_long = {}, .answer = [](const Request&) { return text_response("done."); }});
  std::vector<std::unique_ptr<Link>> silent;
  for (int i = 0; i < 600; ++i) {
    silent.push_back(std::make_unique<Link>(server->port()));
    if (i % 2 == 0) silent.back()->send_text("GET / HTTP/1.1\r\nHo");
  }
  const Link link(server->port());
  link.send_text(get("/read"));
  EXPECT_EQ(link.hear("done.").find("HTTP/1.1 200"), 0U);
  EXPECT_EQ(silent.front()->hear("never"), "") << "closed, and not after the time for a request";
}

TEST(HttpServer, WhatIsNotHttpOrNoAddressIsRefusedAtTheStart) {
  ServerSettings settings;
  settings.address.port = 0;
  settings.proxies = {"proxy.shop"};
  EXPECT_NE(Server::start(settings, {}).error().find("\"proxy.shop\" is not an IP address"), std::string::npos);
  settings.proxies.clear();
  settings.tls_certificate = "/nothing/here.pem";
  settings.tls_key = "/nothing/key.pem";
  EXPECT_NE(Server::start(settings, {}).error().find("/nothing/here.pem"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::http
