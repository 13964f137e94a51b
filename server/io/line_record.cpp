// Two slots of fixed size, each with a sequence number and a check sum; a change goes to the slot of the older one, by
// pwrite() and fdatasync(). A slot that a power failure broke is not valid, and the other one still says what was true
// before: the change was not acknowledged. This costs one synchronous write of a page that lies on the disk already,
// where a new file and a rename cost two, with the journal of the file system; and it needs no space on a full disk.
#include "server/io/line_record.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

namespace dripfeed::io {

namespace {

constexpr std::size_t kSlotBytes = 1024;
constexpr std::size_t kSlotStep = 4096;  // the slots lie in different pages and sectors
constexpr std::size_t kFileBytes = 2 * kSlotStep;
constexpr std::size_t kSumBytes = 17;  // 16 hexadecimal digits and a line feed
constexpr std::string_view kHead = "dripfeed line record 1\n";

constexpr std::array<std::string_view, 3> kStates = {"clean", "sending", "torn"};

struct Field {
  std::string_view name;
  std::string LineRecord::* text;
  std::size_t most_bytes;
};
// Their sum, with the names and the numbers, stays below a slot.
constexpr std::array kFields = {
    Field{"line", &LineRecord::line, 160},     Field{"what", &LineRecord::what, 120},
    Field{"why", &LineRecord::why, 240},       Field{"by", &LineRecord::by, 160},
    Field{"device", &LineRecord::device, 140},
};

// One line of text: cut at the start of a character, without control characters.
std::string fitting(std::string_view text, std::size_t most_bytes) {
  std::string fit(text.substr(0, most_bytes));
  if (text.size() > most_bytes) {
    while (!fit.empty() && (static_cast<unsigned char>(text[fit.size()]) & 0xC0U) == 0x80U) fit.pop_back();
  }
  std::ranges::replace_if(fit, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
  return fit;
}

std::string slot_of(const LineRecord& record, std::uint64_t sequence) {
  std::string slot(kHead);
  slot += fmt::format("sequence {}\nstate {}\nat_ms {}\n", sequence, name_of(record.state), record.at_ms);
  for (const Field& field : kFields) {
    slot += fmt::format("{} {}\n", field.name, fitting(record.*field.text, field.most_bytes));
  }
  slot.resize(kSlotBytes - kSumBytes, '\n');
  return slot + fmt::format("{:016x}\n", fnv1a(slot));
}

struct Slot {
  std::uint64_t sequence = 0;
  LineRecord record{};
};

template <class T>
bool read_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

bool read_state(std::string_view text, RecordState& state) {
  const auto* const found = std::ranges::find(kStates, text);
  if (found == kStates.end()) return false;
  state = static_cast<RecordState>(found - kStates.begin());
  return true;
}

// Names that it does not know are a later version's and do not change what the others say.
bool read_field(std::string_view name, std::string_view value, Slot& slot) {
  if (name == "sequence") return read_number(value, slot.sequence);
  if (name == "state") return read_state(value, slot.record.state);
  if (name == "at_ms") return read_number(value, slot.record.at_ms);
  const auto* const field = std::ranges::find(kFields, name, &Field::name);
  if (field != kFields.end()) slot.record.*(field->text) = value;
  return true;
}

std::optional<Slot> parse(std::string_view bytes) {
  const std::string_view body = bytes.substr(0, kSlotBytes - kSumBytes);
  if (!body.starts_with(kHead) || bytes.substr(body.size()) != fmt::format("{:016x}\n", fnv1a(body))) return {};
  Slot slot;
  std::string_view rest = body.substr(kHead.size());
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) continue;
    if (!read_field(line.substr(0, space), line.substr(space + 1), slot)) return {};
  }
  return slot;
}

}  // namespace

std::string_view name_of(RecordState state) { return kStates[static_cast<std::size_t>(state)]; }

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

std::string text_of_time(std::int64_t at_ms) {
  const std::chrono::sys_seconds at(std::chrono::seconds(at_ms / 1000));
  return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
}

std::string describe(const LineRecord& record) {
  const auto sentence = [&](std::string_view end) {
    return fmt::format("{} by {} at {} {}", record.what, record.by, text_of_time(record.at_ms), end);
  };
  switch (record.state) {
    case RecordState::clean: return {};
    case RecordState::sending: return sentence("ended without a report of how");
    case RecordState::torn: return sentence(fmt::format("broke off inside a block: {}", record.why));
  }
  return {};
}

int sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return error;
}

RecordFile::RecordFile(RecordFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      sequence_(other.sequence_),
      record_(std::move(other.record_)) {}

RecordFile& RecordFile::operator=(RecordFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  std::swap(sequence_, other.sequence_);
  std::swap(record_, other.record_);
  return *this;
}

RecordFile::~RecordFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string RecordFile::system_error() const {
  return fmt::format("the record of the line, {}: {}", path_, std::strerror(errno));
}

std::expected<RecordFile, std::string> RecordFile::open(const std::string& path) {
  RecordFile file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0664), path);
  if (file.descriptor_ < 0) return std::unexpected(file.system_error());
  const off_t size = ::lseek(file.descriptor_, 0, SEEK_END);
  if (size < 0) return std::unexpected(file.system_error());
  const auto ready = size == 0 ? file.make() : file.read();
  if (!ready) return std::unexpected(ready.error());
  return file;
}

std::expected<LineRecord, std::string> RecordFile::look(const std::string& path) {
  RecordFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW), path);
  if (file.descriptor_ < 0 && errno == ENOENT) return LineRecord{};
  if (file.descriptor_ < 0) return std::unexpected(file.system_error());
  if (auto read = file.read(); !read) return std::unexpected(read.error());
  return std::move(file.record_);
}

std::expected<void, std::string> RecordFile::make() {
  std::string empty = slot_of({}, 0);
  empty.resize(kFileBytes, '\0');
  if (::pwrite(descriptor_, empty.data(), empty.size(), 0) != static_cast<ssize_t>(empty.size()) ||
      ::fsync(descriptor_) != 0)
    return std::unexpected(system_error());
  errno = sync_folder(std::filesystem::path(path_).parent_path().string());
  if (errno != 0) return std::unexpected(system_error());
  return {};
}

std::expected<void, std::string> RecordFile::read() {
  std::array<char, kFileBytes> bytes{};
  const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), 0);
  if (count < 0) return std::unexpected(system_error());
  std::optional<Slot> newest;
  for (const std::size_t at : {std::size_t{0}, kSlotStep}) {
    auto slot = parse(std::string_view(bytes.data() + at, kSlotBytes));
    if (slot && (!newest || slot->sequence > newest->sequence)) newest = std::move(slot);
  }
  if (newest) {
    sequence_ = newest->sequence;
    record_ = std::move(newest->record);
    return {};
  }
  // No one knows what it said. What is not known to be whole counts as torn.
  record_ = {.state = RecordState::torn,
             .what = "what was sent last",
             .why = fmt::format("nothing is known, because the record {} is damaged", path_),
             .by = "an unknown command"};
  return {};
}

std::expected<void, std::string> RecordFile::write(const LineRecord& record) {
  const std::uint64_t sequence = sequence_ + 1;
  const std::string slot = slot_of(record, sequence);
  const auto at = static_cast<off_t>((sequence % 2) * kSlotStep);
  const ssize_t count = ::pwrite(descriptor_, slot.data(), slot.size(), at);
  if (count >= 0 && count != static_cast<ssize_t>(slot.size())) errno = ENOSPC;
  if (count != static_cast<ssize_t>(slot.size()) || ::fdatasync(descriptor_) != 0)
    return std::unexpected(system_error());
  sequence_ = sequence;
  record_ = record;
  return {};
}

}  // namespace dripfeed::io
