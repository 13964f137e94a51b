// How long a search of 10,000 programs takes, and what putting them into the library costs. By hand, not by ctest:
//   ninja -C build/dev library_search && build/dev/library_search [PROGRAMS] [LINES EACH]
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "store/sqlite/library.h"

namespace {

using namespace dripfeed;
using Clock = std::chrono::steady_clock;

std::string fixed(double value) { return text::format_fixed(value, 2); }

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

constexpr const char* kThings[] = {"PUMP",   "HOUSING", "FLANGE", "SHAFT",   "BRACKET", "VALVE",
                                   "PISTON", "COVER",   "GEAR",   "ADAPTER", "BUSHING", "MANIFOLD"};
constexpr const char* kComments[] = {"ROUGH",         "FINISH",  "DRILL 8.5",   "TAP M10",
                                     "FACE MILL D63", "CHAMFER", "SECOND SIDE", "CHECK CLAMPS"};

class Shop {
 public:
  explicit Shop(std::size_t lines) : lines_(lines) {}

  store::LibraryEntry program(store::Id id) {
    store::LibraryEntry entry{.program = id, .revision = 1, .change = id};
    entry.name = fmt::format("{}-{}-{:05}", pick(kThings), pick(kThings), id);
    entry.numbers = fmt::format("O{:04}", id % 10000);
    entry.labels = fmt::format("customer{}/{}", id % 50, pick(kThings));
    entry.part = fmt::format("R-{}", id);
    entry.machines = fmt::format("mill-{}", id % 12);
    for (int i = 0; i < 12; ++i) entry.comments += fmt::format("{}\n", pick(kComments));
    entry.text = fmt::format("T{:02}{:02} M06\nG90 G54 G00 X0. Y0.\n", id % 40, id % 40);
    for (std::size_t i = 0; i < lines_; ++i)
      entry.text += fmt::format("G01 X{}.{:03} Y{}.{:03} F{}\n", random_() % 400, random_() % 1000, random_() % 400,
                                random_() % 1000, 100 + random_() % 20);
    entry.names = {entry.numbers, entry.name};
    entry.calls = {{fmt::format("O{}", 9000 + id % 50), store::CallKind::macro, 7}};
    return entry;
  }

 private:
  template <std::size_t N>
  const char* pick(const char* const (&from)[N]) {
    return from[random_() % N];
  }
  std::mt19937 random_{7};
  std::size_t lines_;
};

double median(std::vector<double> all) {
  std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
  return all[all.size() / 2];
}

void measure(store::Library& library, const char* what, const std::vector<std::string>& searches) {
  std::vector<double> times;
  std::size_t hits = 0;
  for (int round = 0; round < 5; ++round)
    for (const std::string& words : searches) {
      const auto begin = Clock::now();
      const auto page = library.search(words, {.limit = 20, .after = {}}, false);
      times.push_back(ms_since(begin));
      hits += page ? page->items.size() : 0;
    }
  fmt::print("{:<28} median {} ms, most {} ms, {} hits on the first page\n", what, fixed(median(times)),
             fixed(*std::ranges::max_element(times)),
             fixed(static_cast<double>(hits) / static_cast<double>(times.size())));
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t programs = 10'000;
  std::size_t lines = 300;
  for (int i = 1; i < argc; ++i) {
    const std::string_view text = argv[i];
    std::from_chars(text.data(), text.data() + text.size(), i == 1 ? programs : lines);
  }
  const auto folder = std::filesystem::temp_directory_path() / "dripfeed_library_search";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "library").string();
  auto library = sqlite::open_library(path);
  if (!library) return 1;
  Shop shop(lines);
  std::vector<double> puts;
  std::size_t bytes = 0;
  constexpr std::size_t kBatch = 32;
  const auto begin = Clock::now();
  for (store::Id id = 1; id <= programs;) {
    std::vector<store::LibraryEntry> batch;
    for (; batch.size() < kBatch && id <= programs; ++id) batch.push_back(shop.program(id));
    for (const store::LibraryEntry& one : batch) bytes += one.text.size();
    const auto put = Clock::now();
    if (!(*library)->put(batch, id - 1)) return 1;
    puts.push_back(ms_since(put));
  }
  fmt::print("{} programs, {} MB of text, put in {} s; {} at once: median {} ms, most {} ms; file {} MB\n", programs,
             fixed(static_cast<double>(bytes) / 1e6), fixed(ms_since(begin) / 1e3), kBatch, fixed(median(puts)),
             fixed(*std::ranges::max_element(puts)),
             fixed(static_cast<double>(std::filesystem::file_size(path)) / 1e6));
  std::vector<double> ones;
  for (store::Id id = 1; id <= 50; ++id) {
    const auto put = Clock::now();
    if (!(*library)->put({shop.program(id * 7)}, programs + id)) return 1;
    ones.push_back(ms_since(put));
  }
  fmt::print("one put anew: median {} ms, most {} ms\n", fixed(median(ones)), fixed(*std::ranges::max_element(ones)));
  measure(**library, "a name", {"PUMP-FLANGE", "VALVE", "shaft gear", "BRACKET-COVER"});
  measure(**library, "a number", {"O0123", "O77", "R-5000", "04711"});
  measure(**library, "the beginning of a word", {"pu", "val", "hous", "g"});
  measure(**library, "a name with a fault", {"FLANSE", "HUOSING", "MANIFOD", "BRACKTE"});
  measure(**library, "a comment", {"finish", "\"second side\"", "chamfer drill", "\"tap m10\""});
  measure(**library, "a word of the text", {"T0505", "X123.456", "F117", "\"G54 G00\""});
  measure(**library, "what all of them have", {"G01", "M6", "G90 G54", "X*"});
  measure(**library, "what none has", {"unheard", "O99999 pump", "zzz*", "X999.999"});
  library->reset();
  std::filesystem::remove_all(folder);
  return 0;
}
