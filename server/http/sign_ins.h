// Who signs in: at most a few at a time from one address, so that a flood of wrong passwords from one computer leaves
// room in the lane `secret` for the others.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include <boost/asio/ip/address.hpp>

namespace dripfeed::http {

class SignIns {
 public:
  static constexpr unsigned kOfOneAddress = 4;

  // A place of one request; it is free again where this ends, on any thread.
  class Place {
   public:
    Place(SignIns& all, boost::asio::ip::address from) : all_(all), from_(std::move(from)) {}
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() { all_.leave(from_); }

   private:
    SignIns& all_;
    boost::asio::ip::address from_;
  };

  // Nothing where as many are at it as may be.
  std::unique_ptr<Place> take(const boost::asio::ip::address& from) {
    const std::lock_guard lock(mutex_);
    unsigned& count = counts_[from];
    if (count >= kOfOneAddress) return nullptr;
    ++count;
    return std::make_unique<Place>(*this, from);
  }

 private:
  void leave(const boost::asio::ip::address& from) {
    const std::lock_guard lock(mutex_);
    const auto found = counts_.find(from);
    if (--found->second == 0) counts_.erase(found);
  }

  std::mutex mutex_;
  std::map<boost::asio::ip::address, unsigned> counts_;
};

}  // namespace dripfeed::http
