// One client: what it may ask and when, the texts that it has open, and what it gets without asking. A message that
// cannot be answered gets the protocol's error; none of them ends the server but `exit`.
#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "server/lsp/features.h"
#include "server/lsp/frames.h"
#include "server/lsp/params.h"

namespace dripfeed::lsp {

class Session {
 public:
  // `settings` are what holds until the client gives others.
  Session(Surroundings around, Settings settings);

  void take(const FrameReader::Frame& frame);
  // One piece of the work that waits: reading a text that was changed, running one that was saved. False: there is
  // none. A run stops when `is_input_waiting`, and is tried again later.
  bool work(const std::function<bool()>& is_input_waiting);
  // Contents of the messages for the client since the last call.
  std::vector<std::string> output() { return std::exchange(output_, {}); }

  [[nodiscard]] bool is_over() const { return state_ == State::over; }
  // As the protocol has it: 0 where the client asked to shut down before it left, else 1.
  [[nodiscard]] int exit_code() const { return was_shut_down_ ? 0 : 1; }

 private:
  enum class State : std::uint8_t { fresh, running, shut_down, over };
  struct Refusal {
    int code;
    std::string text;
  };
  using Answer = std::expected<Document, Refusal>;
  struct Request {
    std::string_view method;
    Answer (Session::*answer)(const Document& params);
  };
  struct Notification {
    std::string_view method;
    void (Session::*take)(const Document& params);
  };
  static const Request kRequests[];
  static const Notification kNotifications[];

  void message(const Document& message);
  void request(const Document& id, std::string_view method, const Document& params);
  Answer answer(std::string_view method, const Document& params);
  void notification(std::string_view method, const Document& params);
  void send(const Document& message);
  void refuse(const Document& id, const Refusal& refusal);
  void notify(std::string_view method, const Document& params);
  // Each sentence once until another one is shown.
  void show_error(const std::string& text);

  Answer initialize(const Document& params);
  Answer shut_down(const Document& params);
  Answer hover(const Document& params);
  Answer definition(const Document& params);
  Answer symbols(const Document& params);
  Answer completion(const Document& params);
  Answer formatting(const Document& params);
  Answer actions(const Document& params);

  void exit(const Document& params);
  void opened(const Document& params);
  void changed(const Document& params);
  void saved(const Document& params);
  void closed(const Document& params);
  void configured(const Document& params);

  void set_settings(const Document& document);
  OpenText* find(const std::string& uri);
  std::expected<Subject, Refusal> subject_of(const Document& params);
  void publish_reading(OpenText& text);
  void publish_run(OpenText& text, const std::function<bool()>& is_input_waiting);

  Surroundings around_;
  Settings standard_;  // the command's
  Settings settings_;
  State state_ = State::fresh;
  bool was_shut_down_ = false;
  Client client_;
  std::map<std::string, OpenText, std::less<>> texts_;  // by URI
  std::vector<std::string> output_;
  std::string shown_error_;
};

}  // namespace dripfeed::lsp
