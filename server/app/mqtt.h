// Brings states and events to a message broker, and takes nothing from it: no command comes in by this door. A thread
// of its own does it, which waits for the store, and for which no thread waits.
//
//   PREFIX/dripfeed/connection          "online" or, by the broker, "offline"; retained
//   PREFIX/MACHINE/state                where the machine's line stands, as GET /machines gives its status; retained
//   PREFIX/MACHINE/event/job/done       events as CloudEvents; those that are of no machine under PREFIX/dripfeed
//
// Where several servers share a store, each publishes the states of the lines that it has and the events that it wrote,
// so that a broker gets each once, and its connection under PREFIX/dripfeed/NODE.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "server/app/application.h"
#include "server/app/base/round_thread.h"
#include "server/app/ports/broker.h"

namespace dripfeed::app {

struct MqttSettings {
  std::string prefix = "dripfeed";                                 // "plant/hall-2": the ISA-95 path to the machines
  std::string node{};                                              // this server's name among those of its store
  WriteEvent write{};                                              // a CloudEvent
  std::function<std::string(const std::string& machine)> state{};  // of a machine as JSON
};

// Of the server itself, for the broker's will and its opposite. `node`: its name; "": it is alone.
BrokerMessage mqtt_connection(const std::string& prefix, const std::string& node, bool is_online);
// "" or what is wrong with a prefix, as the end of a sentence.
std::string why_no_prefix(std::string_view prefix);

class Mqtt {
 public:
  Mqtt(Application& application, Broker& broker, MqttSettings settings);
  ~Mqtt() { stop(); }
  Mqtt(const Mqtt&) = delete;
  Mqtt& operator=(const Mqtt&) = delete;

  // Informs the broker that the server goes, and ends the thread.
  void stop();

 private:
  struct Shown {
    std::string text;
    std::uint64_t connection = 0;  // over which it went out
    feed::Time again_at{};
  };
  struct Sent {
    std::int64_t number = 0;
    std::uint64_t seq = 0;
    bool is_confirmed = false;
  };

  void round();
  void greet();
  void show_states();
  void show(const std::string& machine);
  void leave_others();
  void take_confirmed();
  void send_events();
  [[nodiscard]] store::Result<std::vector<store::LoggedEvent>> events_after(std::uint64_t seq, std::uint32_t most);
  [[nodiscard]] std::string topic_of(const store::LoggedEvent& event) const;

  Application& application_;
  store::Store& store_;
  const Clock& clock_;
  Broker& broker_;
  MqttSettings settings_;
  std::string reader_;  // under which the store notes how far the broker has come
  std::stop_source ends_;

  // Of the thread alone.
  std::uint64_t connection_ = 0;         // that was greeted
  std::optional<std::uint64_t> seen_;    // the last event that the broker confirmed, with all before it
  std::vector<Sent> sent_;               // events after it, in their order
  std::map<std::string, Shown> states_;  // by machine
  feed::Time next_states_{};
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
