// Data of the control that outlives a program: global user data and system variables, by name and up to three indices.
// A value that no one has set is not known. Where values lie stays the same for the whole run, so that a parameter can
// refer to one.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/ir/program.h"

namespace dripfeed::interpreter {

using Indices = std::array<std::uint32_t, 3>;

struct SharedValue {
  double number = kVacant;
  std::string text;
  bool has_text = false;
};

// What a definition file says of a name; dimensions are 0 where the name has none.
struct SharedDefinition {
  ir::ValueType type = ir::ValueType::real;
  Indices dimensions{};
};

class SharedData {
 public:
  // The number of a name, the same for the whole run.
  std::uint32_t id_of(std::string_view name);
  [[nodiscard]] const std::string& name_of(std::uint32_t id) const { return names_[id]; }
  [[nodiscard]] std::uint32_t name_count() const { return static_cast<std::uint32_t>(names_.size()); }
  // "INI[53]", "$TC_DP3[1,1]"; `used` says how many indices were written.
  [[nodiscard]] std::string name_of_element(std::uint32_t id, const Indices& indices, std::uint32_t used) const;

  // Takes the names that the program (a definition file) declares.
  void define(const ir::Program& program);
  [[nodiscard]] bool has_definitions() const { return !definitions_.empty(); }
  // nullptr when no definition file has the name.
  [[nodiscard]] const SharedDefinition* definition_of(std::uint32_t id) const;

  // nullptr when no one set it.
  [[nodiscard]] const SharedValue* find(std::uint32_t id, const Indices& indices) const;
  // The place of the value, made when it is not there.
  std::uint32_t place_of(std::uint32_t id, const Indices& indices);
  // How many indices the name is written with: the most that were used.
  void note_indices(std::uint32_t id, std::uint32_t used);
  [[nodiscard]] std::uint32_t index_count_of(std::uint32_t id) const { return index_counts_[id]; }
  // A place without a name, for a parameter by reference that no one passed.
  std::uint32_t nameless();
  [[nodiscard]] SharedValue& at(std::uint32_t place) { return values_[place]; }
  // Sets a value by its name as people write it: "INI[53]", "$P_UIFR[1,X,TR]", axes and frame parts by their names.
  void set(std::string_view written, double value);
  // Nothing of the name (and its first index) is known any more: an element was written whose index is not known, or
  // all at once.
  void forget(std::uint32_t id, std::optional<std::uint32_t> first = std::nullopt);

  struct Entry {
    std::uint32_t id = 0;
    Indices indices{};
    std::uint32_t place = 0;
  };
  // All places with a name, in the order in which they came.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  struct Key {
    std::uint32_t id = 0;
    Indices indices{};
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  std::vector<std::string> names_;
  std::vector<std::uint32_t> index_counts_;  // of the name of the same index
  std::unordered_map<std::string, std::uint32_t> ids_;
  std::unordered_map<std::uint32_t, SharedDefinition> definitions_;
  std::unordered_map<Key, std::uint32_t, Hash> places_;
  std::vector<Entry> entries_;
  std::deque<SharedValue> values_;
};

}  // namespace dripfeed::interpreter
