// Calls a fuzz target without libFuzzer: with every seed of the folders that the command line names, with every
// truncation of each, and with mutations whose random numbers start from the seed's own bytes, so that each run does
// the same. What ends the process is written to the file "failed_input" first.
//   fuzz_NAME [--mutations N] FOLDER...      N of each seed; many, to look for faults where there is no libFuzzer
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "tests/fuzz/target.h"

namespace {

constexpr std::size_t kMutations = 120;        // of each seed, unless the command line says how many
constexpr std::size_t kMostTruncations = 600;  // of each seed; longer ones are cut at evenly spaced places

std::string present_input;

// Not for the standard's letter of what a signal handler may do: the process is lost anyway, and the file helps.
void keep_input(int signal) {
  std::ofstream("failed_input", std::ios::binary) << present_input;
  fmt::print(stderr, "signal {}: the input is in ./failed_input, {} bytes\n", signal, present_input.size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(std::string input) {
  present_input = std::move(input);
  // Bytes of their own, so that a sanitizer sees a read beyond them.
  const std::vector<std::uint8_t> bytes(present_input.begin(), present_input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::vector<std::string> seeds_of(std::span<char*> folders) {
  std::vector<std::filesystem::path> paths;
  for (const char* folder : folders) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  std::vector<std::string> seeds;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& seeds) : seeds_(seeds) {}

  std::string mutated(const std::string& seed, std::mt19937& random) {
    std::string out = seed;
    for (std::size_t left = 1 + random() % 4; left > 0; --left) change(out, random);
    return out;
  }

 private:
  static std::size_t place(const std::string& text, std::mt19937& random) {
    return text.empty() ? 0 : random() % text.size();
  }

  void change(std::string& text, std::mt19937& random) {
    // Characters that programs, numbers and lines turn on.
    constexpr std::string_view kTelling = "#[](){}=+-*/.,:;%&\"'$ \t\r\n0189EGMNORXZ\x11\x13\x16\x80\xC2\xFF";
    const std::size_t at = place(text, random);
    const std::size_t count = 1 + random() % 8;
    switch (random() % 7) {
      case 0:
        if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << random() % 8));
        break;
      case 1:
        if (!text.empty()) text[at] = static_cast<char>(random() % 256);
        break;
      case 2: text.erase(at, count); break;
      case 3: text.insert(at, 1, kTelling[random() % kTelling.size()]); break;
      case 4: text.insert(place(text, random), std::string(text, at, count)); break;
      case 5: {
        const std::string& other = seeds_[random() % seeds_.size()];
        text.insert(at, std::string(other, place(other, random), 4 * count));
        break;
      }
      default:
        if (!text.empty()) text[at] = kTelling[random() % kTelling.size()];
        break;
    }
  }

  const std::vector<std::string>& seeds_;
};

}  // namespace

int main(int count, char** arguments) {
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS}) std::signal(signal, keep_input);
  std::span words = std::span(arguments, static_cast<std::size_t>(count)).subspan(1);
  std::size_t mutations = kMutations;
  if (words.size() > 1 && std::string_view(words[0]) == "--mutations") {
    mutations = std::stoul(words[1]);
    words = words.subspan(2);
  }
  const std::vector<std::string> seeds = seeds_of(words);
  if (seeds.empty()) {
    fmt::print(stderr, "use: {} [--mutations N] FOLDER...; the folders must hold seeds\n", arguments[0]);
    return 2;
  }
  std::size_t inputs = 0;
  Mutator mutator(seeds);
  for (const std::string& seed : seeds) {
    run(seed);
    const std::size_t stride = std::max<std::size_t>(1, seed.size() / kMostTruncations);
    for (std::size_t size = 0; size < seed.size(); size += stride, ++inputs) run(seed.substr(0, size));
    std::seed_seq numbers(seed.begin(), seed.end());
    std::mt19937 random(numbers);
    for (std::size_t i = 0; i < mutations; ++i, ++inputs) run(mutator.mutated(seed, random));
  }
  fmt::print("{} seeds, {} inputs made from them\n", seeds.size(), inputs);
  return 0;
}
