#pragma once

#include <functional>
#include <memory>
#include <string>

#include "common/sync/Clock.h"
#include "common/wire/Messages.h"
#include "render_client/receive/ServerLink.h"

namespace boost::asio {
class io_context;
}

namespace coherency {

class LinkState;

/// One connection to one address, from the first packet to the last; a new attempt is a new object. It says
/// hello, takes motion by whichever way it comes, measures the clock and reports, and tells `state` all that
/// it hears. The socket thread's.
class ServerConnection {
 public:
  using OnEnd = std::function<void(const std::string& why)>;
  virtual ~ServerConnection() = default;

  /// Unlike reports, a wish is said sooner or later, the newest one.
  virtual void request(const ModeRequest& wish) = 0;
  /// What LinkState wishes for is said as soon as it can be.
  virtual void sayWishes() = 0;
  /// Says goodbye if that can be said at once, and closes; `on_end` is not called.
  virtual void leave() = 0;
};

/// Begins to connect. `on_end` is called once when it ends by itself, whether it ever was welcomed or not.
/// All that is referred to outlives it.
std::shared_ptr<ServerConnection> connectTo(const std::string& address, boost::asio::io_context& io,
                                            const LinkConfig& config, const Clock& clock, LinkState& state,
                                            ServerConnection::OnEnd on_end);

}  // namespace coherency
