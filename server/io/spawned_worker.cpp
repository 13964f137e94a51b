// posix_spawn, because a fork of a server with threads and a large store would copy its page tables first.
#include "server/io/spawned_worker.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace dripfeed::io {

namespace {

constexpr int kLookEvery_ms = 100;
constexpr std::size_t kPieceBytes = std::size_t{256} << 10U;

// A process group of its own: a signal from the keyboard is for the server. Signals as a program begins with them.
class Attributes {
 public:
  Attributes() {
    ::posix_spawnattr_init(&attributes_);
    sigset_t none;
    sigset_t all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

// The socket becomes standard input and output; nothing else of ours is open but standard error.
class Files {
 public:
  explicit Files(int socket) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, socket, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, socket, STDOUT_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
  }
  ~Files() { ::posix_spawn_file_actions_destroy(&actions_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::expected<WorkerProcess, std::string> WorkerProcess::start(const std::vector<std::string>& command) {
  std::array<int, 2> sockets{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
    return std::unexpected(std::string(std::strerror(errno)));
  std::vector<char*> arguments;
  std::vector<std::string> kept = command;
  for (std::string& one : kept) arguments.push_back(one.data());
  arguments.push_back(nullptr);
  const Attributes attributes;
  const Files files(sockets[1]);
  pid_t process = 0;
  const int fault =
      ::posix_spawn(&process, kept.front().c_str(), files.get(), attributes.get(), arguments.data(), environ);
  ::close(sockets[1]);
  if (fault != 0) {
    ::close(sockets[0]);
    return std::unexpected(std::string(std::strerror(fault)));
  }
  return WorkerProcess(process, sockets[0]);
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : process_(std::exchange(other.process_, 0)), socket_(std::exchange(other.socket_, -1)), end_(other.end_) {}

WorkerProcess::~WorkerProcess() {
  if (socket_ >= 0) ::close(socket_);
  if (process_ == 0) return;
  kill_now();
  wait_for_end();
}

bool WorkerProcess::move_bytes(std::string_view& request, std::string& reply) {
  while (!request.empty()) {
    const ssize_t count = ::send(socket_, request.data(), request.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    if (count < 0) {
      request = {};  // it has ended: what it said before is still to be read
      break;
    }
    request.remove_prefix(static_cast<std::size_t>(count));
    if (request.empty()) ::shutdown(socket_, SHUT_WR);
  }
  for (;;) {
    const std::size_t size = reply.size();
    reply.resize(size + kPieceBytes);
    const ssize_t count = ::recv(socket_, reply.data() + size, kPieceBytes, MSG_DONTWAIT);
    const int fault = count < 0 ? errno : 0;
    reply.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count > 0 || fault == EINTR) continue;
    return fault == EAGAIN || fault == EWOULDBLOCK;
  }
}

WorkerProcess::Exchange WorkerProcess::exchange(std::string_view request, int peer,
                                                const std::function<bool(bool peer_left)>& goes_on) {
  Exchange done;
  if (request.empty()) ::shutdown(socket_, SHUT_WR);
  while (move_bytes(request, done.reply)) {
    const short wanted = request.empty() ? POLLIN : POLLIN | POLLOUT;
    std::array<pollfd, 2> polled = {pollfd{socket_, wanted, 0}, pollfd{peer, POLLRDHUP, 0}};
    ::poll(polled.data(), polled.size(), kLookEvery_ms);
    const bool peer_left = peer >= 0 && (polled[1].revents & (POLLRDHUP | POLLHUP | POLLERR | POLLNVAL)) != 0;
    if (goes_on(peer_left)) continue;
    done.was_given_up = true;
    kill_now();
    break;
  }
  wait_for_end();
  done.end = end_.value_or(ProcessEnd{});
  return done;
}

void WorkerProcess::kill_now() {
  if (!end_) ::kill(process_, SIGKILL);
}

void WorkerProcess::wait_for_end() {
  int status = 0;
  while (!end_) {
    const pid_t found = ::waitpid(process_, &status, 0);
    if (found < 0 && errno == EINTR) continue;
    end_ = ProcessEnd{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                      .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  }
}

bool WorkerProcess::has_ended() {
  int status = 0;
  if (!end_ && ::waitpid(process_, &status, WNOHANG) == process_)
    end_ = ProcessEnd{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                      .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0};
  return end_.has_value();
}

}  // namespace dripfeed::io
