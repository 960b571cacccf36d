#include "render_client/receive/ServerLink.h"

#include <functional>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "render_client/receive/LinkState.h"
#include "render_client/receive/NameLookup.h"
#include "render_client/receive/ServerConnection.h"

namespace coherency {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using std::chrono::milliseconds;

constexpr auto kReconnectAfter = milliseconds(200);

}  // namespace

/// Looks the name up, tries its addresses one after the other, and begins again when the connection ends.
class ServerLink::Impl {
 public:
  Impl(const LinkConfig& config, const Clock& clock) : config_(config), clock_(clock), state_(config, clock) {
    lookUp();
    thread_ = std::thread([this] { io_->run(); });
  }

  ~Impl() {
    asio::post(*io_, [this] {
      if (connection_) connection_->leave();
      io_->stop();
    });
    thread_.join();
    connection_.reset();
  }

  void request(const ModeRequest& wish) {
    asio::post(*io_, [this, wish] {
      if (connection_) connection_->request(wish);
    });
  }

  void requestKeyframe() {
    state_.requestKeyframe();
    asio::post(*io_, [this] {
      if (connection_) connection_->sayWishes();
    });
  }

  LinkState& state() { return state_; }
  const LinkState& state() const { return state_; }

 private:
  void lookUp() {
    // The lookup may outlast the link: it holds the io_context, which then has nobody who runs it.
    lookUpName(config_.host, [this, io = io_](const NameAnswer& answer) {
      asio::post(*io, [this, answer] { onAddresses(answer); });
    });
  }

  void onAddresses(const NameAnswer& answer) {
    addresses_ = answer.addresses;
    next_address_ = 0;
    connectNext("cannot find the host: " + answer.error);
  }

  void connectNext(const std::string& why) {
    if (next_address_ == addresses_.size()) return again(why);
    connection_ = connectTo(addresses_[next_address_++], *io_, config_, clock_, state_,
                            [this](const std::string& reason) {
                              state_.disconnected(reason);
                              connectNext(reason);
                            });
  }

  void again(const std::string& why) {
    state_.disconnected(why);
    reconnect_timer_.expires_after(kReconnectAfter);
    reconnect_timer_.async_wait([this](const error_code& error) {
      if (!error) lookUp();
    });
  }

  const LinkConfig config_;
  const Clock& clock_;
  LinkState state_;
  std::shared_ptr<asio::io_context> io_ = std::make_shared<asio::io_context>(1);
  asio::executor_work_guard<asio::io_context::executor_type> work_{
      io_->get_executor()};  // while a lookup goes on
  asio::steady_timer reconnect_timer_{*io_};
  std::shared_ptr<ServerConnection> connection_;
  std::vector<std::string> addresses_;
  std::size_t next_address_ = 0;
  std::thread thread_;
};

ServerLink::ServerLink(const LinkConfig& config, const Clock& clock)
    : impl_(std::make_unique<Impl>(config, clock)) {}
ServerLink::~ServerLink() = default;

SessionConfig ServerLink::waitForSession(std::int64_t timeout_ns) {
  return impl_->state().waitForSession(timeout_ns);
}
std::optional<SessionConfig> ServerLink::session() const {
  return impl_->state().session();
}
std::uint64_t ServerLink::sessionId() const {
  return impl_->state().sessionId();
}
std::optional<ReceivedPacket> ServerLink::newest() const {
  return impl_->state().newest();
}
bool ServerLink::waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const {
  return impl_->state().waitForTick(tick, timeout_ns);
}
std::optional<ReceivedFrame> ServerLink::nextFrame(std::uint64_t after, std::uint64_t stride,
                                                   ServerTime earliest, std::int64_t draw_ns) const {
  return impl_->state().nextFrame(after, stride, earliest, draw_ns);
}
std::vector<ReceivedFrame> ServerLink::framesBetween(std::uint64_t after, std::uint64_t before,
                                                     std::uint64_t stride) const {
  return impl_->state().framesBetween(after, before, stride);
}
void ServerLink::keepFirstFrom(const std::vector<std::uint64_t>& numbers) {
  impl_->state().keepFirstFrom(numbers);
}
std::optional<ReceivedFrame> ServerLink::firstFrom(std::uint64_t number) const {
  return impl_->state().firstFrom(number);
}
std::uint64_t ServerLink::newestFrame() const {
  return impl_->state().newestFrame();
}
bool ServerLink::waitForFrame(std::uint64_t number, std::int64_t timeout_ns) const {
  return impl_->state().waitForFrame(number, timeout_ns);
}
void ServerLink::requestKeyframe() {
  impl_->requestKeyframe();
}
std::optional<ClientTime> ServerLink::toClient(ServerTime t) const {
  return impl_->state().toClient(t);
}
void ServerLink::requestMode(Mode mode) {
  impl_->request(ModeRequest{mode});
}
void ServerLink::reportFrame(const FrameReport& frame) {
  impl_->state().reportFrame(frame);
}
std::optional<ServerTime> ServerLink::toServer(ClientTime t) const {
  return impl_->state().toServer(t);
}
LinkStats ServerLink::stats() const {
  return impl_->state().stats();
}

}  // namespace coherency
