// A program is read and validated as a check does it; a family by its own reader.
#include "server/lsp/texts.h"

#include <utility>

#include "dialects/compile/render/render.h"
#include "server/lsp/file_uri.h"

namespace dripfeed::lsp {

OpenText::OpenText(std::string uri, std::int64_t version, std::string text)
    : uri_(std::move(uri)), path_(path_of(uri_)), version_(version) {
  set_text(std::move(text));
}

void OpenText::set_text(std::string text) {
  source_ = text::Source(path_.empty() ? uri_ : path_, std::move(text));
  lines_ = Lines(source_.text());
  reading_.reset();
}

void OpenText::change(std::int64_t version, const std::vector<Change>& changes, PositionUnit unit) {
  for (const Change& change : changes) {
    if (!change.range) {
      set_text(change.text);
      continue;
    }
    const std::uint32_t begin = lines_.offset_of(change.range->start, unit);
    const std::uint32_t end = std::max(begin, lines_.offset_of(change.range->end, unit));
    std::string text(source_.text());
    text.replace(begin, end - begin, change.text);
    set_text(std::move(text));
  }
  version_ = version;
  wants_diagnostics = true;
  wants_run = false;
}

namespace {

app::Examination examination_of(const Language& language, const text::Source& source, const std::string& path,
                                const Settings& settings, const Surroundings& around) {
  app::Examination e;
  e.source = source;
  e.dialect = language.dialect;
  e.control = language.control;
  e.inferred = language.inferred;
  e.profile = language.profile.get();
  e.find_called = around.find_called(settings, path);
  return e;
}

}  // namespace

app::Result<const Reading*> OpenText::reading(const Settings& settings, const Surroundings& around) {
  if (reading_) return reading_.get();
  auto made = std::make_unique<Reading>();
  made->report.source = source_;
  if (around.is_family(source_)) {
    made->is_family = true;
    made->report.checks.diagnostics = compile::describe_family(source_).diagnostics;
  } else {
    auto language = around.choose_language(settings, source_);
    if (!language) return std::unexpected(language.error());
    made->language = std::move(*language);
    app::TextReading text = app::read_text(examination_of(made->language, source_, path_, settings, around));
    made->report = std::move(text.report);
    made->read = std::move(text.read);
    made->words = compile::WordIndex(compile::language_of(*made->language.dialect, made->language.control));
  }
  reading_ = std::move(made);
  return reading_.get();
}

app::Result<app::CheckReport> OpenText::examined(const Settings& settings, const Surroundings& around,
                                                 const std::function<std::string()>& used_up) {
  const auto known = reading(settings, around);
  if (!known) return std::unexpected(known.error());
  if ((*known)->is_family) return (*known)->report;
  app::Examination e = examination_of((*known)->language, source_, path_, settings, around);
  e.used_up = used_up;
  return app::examine(e);
}

}  // namespace dripfeed::lsp
