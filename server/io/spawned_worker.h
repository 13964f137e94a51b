// A process of its own for one piece of work: started, given its request, heard to its end, and killed when it takes
// longer than it may or no request waits for it. It shares nothing with this process but one socket.
#pragma once

#include <chrono>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace dripfeed::io {

// How a process ended: its exit code, or the signal that ended it.
struct ProcessEnd {
  int exit_code = 0;
  int signal = 0;
  [[nodiscard]] bool is_good() const { return exit_code == 0 && signal == 0; }
};

class WorkerProcess {
 public:
  // `command`: the program's path and its arguments. Errors: what the system said.
  static std::expected<WorkerProcess, std::string> start(const std::vector<std::string>& command);
  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&&) = delete;
  ~WorkerProcess();  // kills it

  // Gives it the request and reads until it closes its end. `goes_on` is asked now and then; once it says no the
  // process is killed and there is no reply. `peer`: a socket whose other end may go away, which is asked about at
  // once; -1.
  struct Exchange {
    std::string reply;
    bool was_given_up = false;
    ProcessEnd end;
  };
  Exchange exchange(std::string_view request, int peer, const std::function<bool(bool peer_left)>& goes_on);

  // Has it ended by itself?
  [[nodiscard]] bool has_ended();
  [[nodiscard]] pid_t id() const { return process_; }

 private:
  WorkerProcess(pid_t process, int socket) : process_(process), socket_(socket) {}
  // Moves bytes as far as the socket lets it; false at the end of the reply.
  bool move_bytes(std::string_view& request, std::string& reply);
  void kill_now();
  void wait_for_end();

  pid_t process_;
  int socket_;
  std::optional<ProcessEnd> end_;
};

}  // namespace dripfeed::io
