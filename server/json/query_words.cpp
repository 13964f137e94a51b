// One row a parameter that takes words.
#include "server/json/query_words.h"

#include <algorithm>
#include <array>

#include "dialects/ir/control.h"
#include "server/app/jobs/history.h"
#include "server/app/library/importing.h"
#include "server/json/records.h"

namespace dripfeed::json {

namespace {

constexpr std::array<std::string_view, 4> kEndedStates = {"done", "failed", "cancelled", "interrupted"};
constexpr std::array<std::string_view, 2> kAlarmStates = {"open", "all"};
constexpr std::array<std::string_view, 1> kTrue = {"true"};
constexpr std::array<std::string_view, 1> kForms = {"read"};
constexpr std::array<std::string_view, 2> kSearchShelves = {"in_use", "all"};
constexpr std::array<std::string_view, 3> kGSystems = {"A", "B", "C"};
constexpr std::array<std::string_view, 1> kDeviation = {"deviation"};
constexpr std::array<std::string_view, 1> kStock = {"stock"};
constexpr std::array<std::string_view, 2> kTiming = {"feed", "buffer"};
constexpr std::array<std::string_view, 1> kRegion = {"region"};

struct WordsRow {
  std::string_view path;
  std::string_view name;
  std::span<const std::string_view> words;
};
constexpr std::array kRows = {
    WordsRow{"/api/v1/jobs", "state", store::kNames<store::JobState>},
    WordsRow{"/api/v1/history/sums", "by", app::kSumsByNames},
    WordsRow{"/api/v1/history/sums", "state", kEndedStates},
    WordsRow{"/api/v1/orders", "state", store::kNames<store::OrderState>},
    WordsRow{"/api/v1/alarms", "state", kAlarmStates},
    WordsRow{"/api/v1/receipts", "state", store::kNames<store::ReceiptState>},
    WordsRow{"/api/v1/receipts/{id}/text", "form", kForms},
    WordsRow{"/api/v1/webhooks/{id}/deliveries", "state", store::kNames<store::DeliveryState>},
    WordsRow{"/api/v1/imports", "known", app::kKnownNames},
    WordsRow{"/api/v1/imports", "keep_ending", kTrue},
    WordsRow{"/api/v1/imports", "only_look", kTrue},
    WordsRow{"/api/v1/programs", "shelf", store::kNames<store::Shelf>},
    WordsRow{"/api/v1/programs/{id}/path", "delivery", store::kNames<store::Delivery>},
    WordsRow{"/api/v1/programs/{id}/stock", "delivery", store::kNames<store::Delivery>},
    WordsRow{"/api/v1/search", "shelf", kSearchShelves},
    WordsRow{"/api/v1/dialects/{name}/words", "kind", ir::kMachineKindNames},
    WordsRow{"/api/v1/dialects/{name}/words", "g_system", kGSystems},
    WordsRow{"/api/v1/accuracy", "plot", kDeviation},
    WordsRow{"/api/v1/gouge", "plot", kStock},
    WordsRow{"/api/v1/timing", "plot", kTiming},
    WordsRow{"/api/v1/sweep", "plot", kRegion},
};

constexpr std::array<std::string_view, 10> kNumbers = {"program",       "order", "choice", "revision", "with",
                                                       "with_revision", "days",  "count",  "from_ms",  "to_ms"};

}  // namespace

std::span<const std::string_view> query_words(std::string_view path, std::string_view name) {
  const auto row =
      std::ranges::find_if(kRows, [&](const WordsRow& one) { return one.path == path && one.name == name; });
  return row == kRows.end() ? std::span<const std::string_view>() : row->words;
}

bool is_query_number(std::string_view name) { return std::ranges::find(kNumbers, name) != kNumbers.end(); }

}  // namespace dripfeed::json
