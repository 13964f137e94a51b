// Messages are answered one after the other; reading and running texts waits until no message does.
#include "server/lsp/session.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "server/app/base/check_budget.h"
#include "server/json/parse.h"
#include "server/lsp/answers.h"

namespace dripfeed::lsp {

namespace {

// JSON-RPC 2.0 and LSP 3.17.
constexpr int kParseError = -32700;
constexpr int kInvalidRequest = -32600;
constexpr int kMethodNotFound = -32601;
constexpr int kInvalidParams = -32602;
constexpr int kInternalError = -32603;
constexpr int kNotInitialized = -32002;
constexpr int kRequestFailed = -32803;

constexpr int kErrorMessage = 1;  // MessageType.Error

bool is_id(const Document& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

const Session::Request Session::kRequests[] = {
    {"initialize", &Session::initialize},
    {"shutdown", &Session::shut_down},
    {"textDocument/hover", &Session::hover},
    {"textDocument/definition", &Session::definition},
    {"textDocument/documentSymbol", &Session::symbols},
    {"textDocument/completion", &Session::completion},
    {"textDocument/formatting", &Session::formatting},
    {"textDocument/codeAction", &Session::actions},
};

const Session::Notification Session::kNotifications[] = {
    {"exit", &Session::exit},
    {"textDocument/didOpen", &Session::opened},
    {"textDocument/didChange", &Session::changed},
    {"textDocument/didSave", &Session::saved},
    {"textDocument/didClose", &Session::closed},
    {"workspace/didChangeConfiguration", &Session::configured},
};

Session::Session(Surroundings around, Settings settings)
    : around_(std::move(around)), standard_(std::move(settings)), settings_(standard_) {}

void Session::take(const FrameReader::Frame& frame) {
  if (const auto* fault = std::get_if<FrameFault>(&frame)) {
    if (*fault == FrameFault::no_length) return refuse(nullptr, {kParseError, "a message has no Content-Length"});
    return refuse(nullptr, {kInvalidRequest, fmt::format("a message is longer than {} bytes", kLongestMessage_bytes)});
  }
  const auto document = json::parse(std::get<std::string>(frame));
  if (!document) return refuse(nullptr, {kParseError, document.error().text});
  message(*document);
}

void Session::message(const Document& message) {
  const Document* method = member(message, "method");
  const Document* id = member(message, "id");
  const Document* version = member(message, "jsonrpc");
  const Document none;
  const Document& answer_to = id != nullptr && is_id(*id) ? *id : none;
  if (version == nullptr || *version != "2.0")
    return refuse(answer_to, {kInvalidRequest, "a message is an object with \"jsonrpc\": \"2.0\""});
  const bool is_answer =
      method == nullptr && (member(message, "result") != nullptr || member(message, "error") != nullptr);
  if (is_answer) return;  // this server asks nothing
  if (method == nullptr || !method->is_string()) return refuse(answer_to, {kInvalidRequest, "method must be a text"});
  const Document* params = member(message, "params");
  const Document& given = params == nullptr ? none : *params;
  if (id == nullptr) return notification(method->get_ref<const std::string&>(), given);
  if (!is_id(*id)) return refuse(none, {kInvalidRequest, "id must be a text or a whole number"});
  request(*id, method->get_ref<const std::string&>(), given);
}

void Session::request(const Document& id, std::string_view method, const Document& params) {
  const Answer made = answer(method, params);
  if (!made) return refuse(id, made.error());
  send({{"jsonrpc", "2.0"}, {"id", id}, {"result", *made}});
}

Session::Answer Session::answer(std::string_view method, const Document& params) {
  const auto refused = [](int code, std::string text) { return std::unexpected(Refusal{code, std::move(text)}); };
  if (state_ == State::shut_down) return refused(kInvalidRequest, "the server was shut down");
  const bool is_first = method == "initialize";
  if (state_ == State::fresh && !is_first) return refused(kNotInitialized, "initialize comes first");
  if (state_ == State::running && is_first) return refused(kInvalidRequest, "initialize was answered already");
  const auto found = std::ranges::find(kRequests, method, &Request::method);
  if (found == std::end(kRequests)) return refused(kMethodNotFound, fmt::format("{} is not known", method));
  try {
    return (this->*found->answer)(params);
  } catch (const std::exception& error) {
    return refused(kInternalError, fmt::format("{}: {}", method, error.what()));
  }
}

void Session::notification(std::string_view method, const Document& params) {
  const bool is_exit = method == "exit";
  if (state_ != State::running && !is_exit) return;
  const auto found = std::ranges::find(kNotifications, method, &Notification::method);
  if (found == std::end(kNotifications)) return;  // the protocol asks for silence
  try {
    (this->*found->take)(params);
  } catch (const std::exception& error) {
    show_error(fmt::format("{}: {}", method, error.what()));
  }
}

void Session::send(const Document& message) { output_.push_back(json::dump(message)); }

void Session::refuse(const Document& id, const Refusal& refusal) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", refusal.code}, {"message", refusal.text}}}});
}

void Session::notify(std::string_view method, const Document& params) {
  send({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
}

void Session::show_error(const std::string& text) {
  if (std::exchange(shown_error_, text) == text) return;
  notify("window/showMessage", {{"type", kErrorMessage}, {"message", "dripfeed: " + text}});
}

Session::Answer Session::initialize(const Document& params) {
  state_ = State::running;
  client_ = read_client(params);
  if (const Document* options = member(params, "initializationOptions")) set_settings(*options);
  return capabilities(client_.unit, around_.version);
}

Session::Answer Session::shut_down(const Document& /*params*/) {
  state_ = State::shut_down;
  was_shut_down_ = true;
  texts_.clear();
  return Document();
}

void Session::exit(const Document& /*params*/) { state_ = State::over; }

// Settings of which one is wrong leave all as they were.
void Session::set_settings(const Document& document) {
  auto settings = read_settings(document, standard_);
  if (!settings) return show_error(settings.error());
  if (const auto language = around_.choose_language(*settings, text::Source()); !language)
    return show_error(language.error().text);
  settings_ = std::move(*settings);
  for (auto& [uri, text] : texts_) {
    text.forget_reading();
    text.wants_diagnostics = true;
  }
}

void Session::configured(const Document& params) {
  const Document* settings = member(params, "settings");
  if (settings == nullptr) return;
  const Document* own = member(*settings, "dripfeed");
  set_settings(own == nullptr ? *settings : *own);
}

void Session::opened(const Document& params) {
  auto opened = read_opened(params);
  if (!opened) return show_error(opened.error());
  const std::string uri = opened->uri;
  texts_.insert_or_assign(uri, OpenText(uri, opened->version, std::move(opened->text)));
}

void Session::changed(const Document& params) {
  const auto changed = read_changed(params);
  if (!changed) return show_error(changed.error());
  if (OpenText* text = find(changed->uri)) text->change(changed->version, changed->changes, client_.unit);
}

// Programs that it calls may have been changed, too.
void Session::saved(const Document& params) {
  const auto uri = read_uri(params);
  OpenText* text = uri ? find(*uri) : nullptr;
  if (text == nullptr) return;
  text->forget_reading();
  text->wants_diagnostics = true;
  text->wants_run = true;
}

void Session::closed(const Document& params) {
  const auto uri = read_uri(params);
  const OpenText* text = uri ? find(*uri) : nullptr;
  if (text == nullptr) return;
  notify("textDocument/publishDiagnostics", published(*text, {}, ""));
  texts_.erase(*uri);
}

OpenText* Session::find(const std::string& uri) {
  const auto found = texts_.find(uri);
  return found == texts_.end() ? nullptr : &found->second;
}

std::expected<Subject, Session::Refusal> Session::subject_of(const Document& params) {
  const auto uri = read_uri(params);
  if (!uri) return std::unexpected(Refusal{kInvalidParams, uri.error()});
  OpenText* text = find(*uri);
  if (text == nullptr) return std::unexpected(Refusal{kInvalidParams, fmt::format("{} is not open", *uri)});
  const auto reading = text->reading(settings_, around_);
  if (!reading) return std::unexpected(Refusal{kRequestFailed, reading.error().text});
  return Subject{*text, **reading, client_.unit};
}

Session::Answer Session::hover(const Document& params) {
  const auto of = subject_of(params);
  if (!of) return std::unexpected(of.error());
  const auto at = read_position(params);
  if (!at) return std::unexpected(Refusal{kInvalidParams, at.error()});
  const auto hover = hover_at(*of, *at);
  return hover ? written(*hover) : Document();
}

Session::Answer Session::definition(const Document& params) {
  const auto of = subject_of(params);
  if (!of) return std::unexpected(of.error());
  const auto at = read_position(params);
  if (!at) return std::unexpected(Refusal{kInvalidParams, at.error()});
  return written(definition_at(*of, *at, around_.find_called(settings_, of->text.path())));
}

Session::Answer Session::symbols(const Document& params) {
  const auto of = subject_of(params);
  if (!of) return std::unexpected(of.error());
  return written(symbols_of(*of), of->text, client_.takes_symbol_trees);
}

Session::Answer Session::completion(const Document& params) {
  const auto of = subject_of(params);
  if (!of) return std::unexpected(of.error());
  const auto at = read_position(params);
  if (!at) return std::unexpected(Refusal{kInvalidParams, at.error()});
  return written(proposals_at(*of, *at));
}

Session::Answer Session::formatting(const Document& params) {
  const auto of = subject_of(params);
  if (!of) return std::unexpected(of.error());
  const auto edits = renumbered(*of, settings_);
  if (!edits) return std::unexpected(Refusal{kRequestFailed, edits.error().text});
  return written(*edits);
}

Session::Answer Session::actions(const Document& params) {
  const auto of = subject_of(params);
  if (!of) return std::unexpected(of.error());
  const auto range = read_range(params);
  if (!range) return std::unexpected(Refusal{kInvalidParams, range.error()});
  Document list = Document::array();
  for (const Action& one : actions_in(*of, *range)) list.push_back(written(one, of->text, settings_.docs));
  return list;
}

bool Session::work(const std::function<bool()>& is_input_waiting) {
  for (auto& [uri, text] : texts_) {
    if (!text.wants_diagnostics && !(text.wants_run && settings_.seconds > 0)) continue;
    try {
      if (text.wants_diagnostics)
        publish_reading(text);
      else
        publish_run(text, is_input_waiting);
    } catch (const std::exception& error) {
      text.wants_diagnostics = text.wants_run = false;
      show_error(fmt::format("{}: {}", uri, error.what()));
    }
    return true;
  }
  return false;
}

void Session::publish_reading(OpenText& text) {
  text.wants_diagnostics = false;
  const auto reading = text.reading(settings_, around_);
  if (!reading) {
    text.wants_run = false;
    return show_error(reading.error().text);
  }
  const Subject of{text, **reading, client_.unit};
  notify("textDocument/publishDiagnostics", published(text, faults_of(of, (*reading)->report), settings_.docs));
}

void Session::publish_run(OpenText& text, const std::function<bool()>& is_input_waiting) {
  const auto reading = text.reading(settings_, around_);
  const auto out_of_time = app::time_budget(settings_.seconds);
  bool was_interrupted = false;
  const auto report = text.examined(settings_, around_, [&] {
    was_interrupted = was_interrupted || is_input_waiting();
    return was_interrupted ? std::string("the editor") : out_of_time();
  });
  if (was_interrupted) return;
  text.wants_run = false;
  if (!reading || !report) return;
  const Subject of{text, **reading, client_.unit};
  notify("textDocument/publishDiagnostics", published(text, faults_of(of, *report), settings_.docs));
}

}  // namespace dripfeed::lsp
