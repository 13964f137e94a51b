// The list of machines, kept row by row: a row is written again where the store or its line changed. A hall's screens
// ask for it all the time, and most lines stand still.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "server/app/application.h"
#include "server/http/request.h"
#include "server/http/titles.h"
#include "server/json/records.h"

namespace dripfeed::http {

class MachineList {
 public:
  static constexpr std::size_t kMostPages = 64;  // then all are read again

  MachineList(app::Application& application, Titles& titles) : application_(application), titles_(titles) {}
  // `version`: of the store, asked for with this request. From any thread.
  Response answer(const store::PageRequest& request, std::uint64_t version);

 private:
  struct Row {
    store::Machine machine;  // without its profile
    json::ProfileHead head;
    app::LineFacts facts;
    std::string text;
    bool is_kept = false;  // false: the text is to be written again
  };
  struct Page {
    std::uint64_t version = 0;
    std::vector<Row> rows;
    std::string next;
  };
  using Key = std::pair<std::string, std::uint32_t>;  // where a page begins, and how long it is at most

  store::Result<Page> read(const store::PageRequest& request, std::uint64_t version);
  const std::string& text_of(Row& row);

  app::Application& application_;
  Titles& titles_;
  std::mutex mutex_;
  std::map<Key, Page> pages_;
};

}  // namespace dripfeed::http
