#include "render_client/RenderClient.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

#include "common/sync/StopSignal.h"
#include "render_client/draw/PictureSize.h"
#include "render_client/present/Png.h"

namespace coherency {
namespace {

constexpr std::int64_t kPollNs = 50'000'000;
constexpr double kMillisecond = 1e6;  // ns
constexpr std::int64_t kStatusNs = 500'000'000;

std::unique_ptr<Display> makeDisplay(const ClientOptions& options) {
  DisplayConfig config;
  config.width = options.width * eyeCount(eyeChoice(options.eye));
  config.height = options.height;
  config.fullscreen = options.fullscreen;
  config.monitor = options.monitor;
  config.title = fmt::format("Coherency: {} eye", options.eye);
  return options.window ? makeWindowDisplay(config) : makeHeadlessDisplay(config);
}

std::vector<std::pair<std::string, std::string>> pictureText(const Replica& replica,
                                                             const ClientOptions& options) {
  std::string dofs;
  for (const auto units : replica.sample().units) dofs += fmt::format("{}{}", dofs.empty() ? "" : " ", units);
  const BasePose& base = replica.world().driven().base;
  return {{"eye", options.eye},
          {"scene", replica.session().scene.name},
          {"hmd", options.hmd.name},
          {"frame", fmt::format("{}", replica.frame())},
          {"tick", fmt::format("{}", replica.world().tick)},
          {"sequence", fmt::format("{}", replica.sample().sequence)},
          {"dof_units", dofs},
          {"base", fmt::format("{} {} {} {}", base.x_nm, base.y_nm, base.z_nm, base.heading_units)},
          {"hash", fmt::format("{:016x}", replica.hash())}};
}

/// So that a folder that will not do is known at the start and not at the end.
void checkFolder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && access(folder.c_str(), W_OK) != 0) error.assign(errno, std::generic_category());
  if (error)
    throw std::runtime_error(fmt::format(
        "--snapshot-dir {}: {}; name a folder that can be made and written to", folder, error.message()));
}

}  // namespace

RenderClient::RenderClient(const ClientOptions& options, const Clock& clock)
    : options_(options),
      clock_(clock),
      started_(now()),
      link_({options.server.host, options.server.port, options.eye, options.key}, clock),
      pacing_(link_, clock),
      eyes_(eyeChoice(options.eye)),
      overlay_(describe(options.server), started_) {
  if (!options.snapshot_dir.empty()) checkFolder(options.snapshot_dir);
  const double wait_s =
      options.duration_s > 0.0 ? std::min(options.wait_s, options.duration_s) : options.wait_s;
  const auto wait_ns = static_cast<std::int64_t>(wait_s * 1e9);
  const SessionConfig session = link_.waitForSession(wait_ns);
  display_ = makeDisplay(options);
  buildWorld(session);
  awaitMotion(started_ + std::max<std::int64_t>(wait_ns, 1'000'000'000));
  planPictures();
  if (!options.video.empty()) video_.emplace(options.video, 1.0 / pacing_.secondsBetween());
}

void RenderClient::awaitMotion(ClientTime deadline) {
  while (!link_.waitForFrame(1, kPollNs) && now() < deadline && !closed_) handleInput();
  if (closed_) return;
  const auto first = link_.nextFrame(0, 1, {0}, 0);
  if (!first)
    throw std::runtime_error(fmt::format(
        "{} welcomed this client, but no motion came, neither over UDP nor over TCP: start the server "
        "again, and look at its messages",
        describe(options_.server)));
  newest_arrived_ = first->arrived;
}

void RenderClient::planPictures() {
  if (options_.snapshot_dir.empty()) return;
  const std::vector<double>& times = options_.snapshot_at_s;
  for (const double time : times) {
    const std::string number = times.size() > 1 ? fmt::format("_{}", planned_.size() + 1) : "";
    planned_.push_back({time, options_.eye + number});
  }
  keepPlanned();
  const std::uint64_t newest = link_.newestFrame();
  if (!times.empty() && newest > pacing_.frameAt(times.front()))
    throw std::runtime_error(
        fmt::format("--snapshot-at {}: the session has run for {:.1f} s already; name a later moment",
                    times.front(), pacing_.momentS(newest)));
}

void RenderClient::keepPlanned() {
  std::vector<std::uint64_t> numbers;
  for (const PlannedPicture& picture : planned_) numbers.push_back(pacing_.frameAt(picture.session_s));
  link_.keepFirstFrom(numbers);
}

void RenderClient::buildWorld(const SessionConfig& session) {
  renderer_.reset();  // the renderer holds on to the old replica's scene
  replica_.emplace(session);
  views_.clear();
  fitPictures();
  renderer_.emplace(
      replica_->scene(), picture_.width * eyeCount(eyes_), picture_.height,
      RendererSettings{
          .samples = options_.samples, .detail_px = options_.detail_px, .smallest_px = options_.smallest_px});
  renderer_->setDisplay(options_.hmd, eyes_, options_.render_scale);
  beginFrames();
}

/// To the display, whose window may have another size than it had.
void RenderClient::fitPictures() {
  display_size_ = {options_.width, options_.height};
  if (display_->hasWindow()) display_size_ = {display_->width() / eyeCount(eyes_), display_->height()};
  picture_ =
      pictureSize(options_.hmd, eyes_, display_size_.width, display_size_.height, options_.render_scale);
}

void RenderClient::beginFrames() {
  pacing_.begin(replica_->session(), options_.fps);
  keepPlanned();
}

void RenderClient::followSession() {
  const auto session = link_.session();
  if (!session || session->session_id == replica_->session().session_id) return;
  if (sameWorld(*session, replica_->session())) {
    replica_->follow(*session);
    beginFrames();
  } else {
    buildWorld(*session);
  }
}

/// The frame of the next picture that was asked for, however slow this machine is, so that both eyes'
/// pictures are of one moment.
std::optional<ReceivedFrame> RenderClient::plannedFrame() const {
  if (planned_.empty()) return std::nullopt;
  return pacing_.firstFrom(pacing_.frameAt(planned_.front().session_s));
}

void RenderClient::run(const std::function<void(const ClientStats&)>& onStatus) {
  catchStopSignals();
  ClientTime last_status = now();
  while (!finished()) {
    if (now() - last_status >= kStatusNs) {
      last_status = now();
      const ClientStats latest = stats();
      overlay_.refresh(latest, *replica_);
      onStatus(latest);
    }
    handleInput();
    followSession();
    const auto picture = plannedFrame();
    if (const auto frame = picture ? picture : pacing_.await())
      drawFrame(*frame, picture.has_value());
    else
      drawAgain();
  }
  endVideo();
  takeWhatIsLeft();
  if (!video_fault_.empty()) throw std::runtime_error(video_fault_);
}

/// At the end of a run.
void RenderClient::takeWhatIsLeft() {
  if (options_.snapshot_dir.empty()) return;
  if (options_.snapshot_at_s.empty() && !views_.empty()) return writeLastPicture();
  if (!planned_.empty() || views_.empty())
    throw std::runtime_error(
        fmt::format("no picture: the run ended at {:.1f} s of the session, before the moment asked for",
                    pacing_.momentS(pacing_.newestShown())));
}

void RenderClient::drawFrame(const ReceivedFrame& frame, bool is_picture) {
  newest_arrived_ = frame.arrived;
  pacing_.choose(frame);
  if (!replica_->apply(frame.state)) {  // never drawn wrong: the picture before it stays
    if (is_picture)
      throw std::runtime_error(fmt::format(
          "--snapshot-at {}: the state of that moment does not have its hash", planned_.front().session_s));
    return pacing_.mismatched(frame);
  }
  const ClientTime begun = now();
  drawViews();
  std::int64_t draw_ns = now() - begun;
  takeSnapshots(is_picture);  // now and then, and not to be allowed for
  const ClientTime drawn = now();
  addToVideo(frame.state.number);
  showText();
  draw_ns += now() - drawn;
  pacing_.awaitPhotons(frame);
  present();
  countPicture();
  pacing_.shown(frame, replica_->world().tick, replica_->hash(), draw_ns);
}

/// Complete when it returns: only then is it known what a picture takes.
void RenderClient::drawViews() {
  fitPictures();
  renderer_->resize(picture_.width * eyeCount(eyes_), picture_.height);
  eyeViews(replica_->scene(), replica_->world().mode, options_.hmd, eyes_, picture_.width, picture_.height,
           views_);
  const std::size_t compilations = renderer_->compilations();
  renderer_->draw(views_);
  renderer_->finish();
  if (renderer_->compilations() != compilations) noteFoundToMove();
}

void RenderClient::present() {
  if (display_->hasWindow()) renderer_->present(display_->width(), display_->height());
  display_->present();
}

/// Nothing new has come: what was shown stays, and says that it is old.
void RenderClient::drawAgain() {
  if (views_.empty()) return;
  drawViews();
  takeSnapshots(false);
  showText();
  present();
  countPicture();
}

void RenderClient::noteFoundToMove() {
  ++recompilations_;
  for (const std::string& path : renderer_->report().found)
    if (std::find(found_to_move_.begin(), found_to_move_.end(), path) == found_to_move_.end())
      found_to_move_.push_back(path);
}

void RenderClient::countPicture() {
  ++frames_;
  last_frame_ = now();
  if (!first_frame_) first_frame_ = last_frame_;
}

/// Before any text is drawn over the picture.
void RenderClient::takeSnapshots(bool is_picture) {
  if (is_picture) {
    writeSnapshot(planned_.front().name);
    planned_.pop_front();
    keepPlanned();
  }
  if (snapshot_due_) trySnapshotByKey();
  snapshot_due_ = false;
}

void RenderClient::trySnapshotByKey() {
  const std::string name = fmt::format("{}_{:03}", options_.eye, ++snapshots_);
  try {
    writeSnapshot(name);
    overlay_.notify(fmt::format("wrote {}.png", name), now());
  } catch (const std::exception& e) {
    overlay_.notify(e.what(), now());
  }
}

void RenderClient::showText() {
  const std::string text = overlay_.text(now(), now() - newest_arrived_, *replica_, display_->hasWindow());
  if (!text.empty()) renderer_->drawText(views_, text);
}

void RenderClient::handleInput() {
  const DisplayInput input = display_->poll();
  closed_ = closed_ || input.close;
  snapshot_due_ = snapshot_due_ || input.snapshot;
  if (input.toggle_overlay) overlay_.toggle();
  if (input.switch_mode) switchMode();
}

/// The server decides, for all its clients at the same tick.
void RenderClient::switchMode() {
  if (replica_->scene().robot() != nullptr) {
    link_.requestMode(replica_->world().mode == Mode::Operator ? Mode::Robot : Mode::Operator);
    return;
  }
  overlay_.notify("there is no robot in this scene", now());
}

/// Drawn once more, without the text that lies over it.
void RenderClient::writeLastPicture() {
  renderer_->draw(views_);
  writeSnapshot(options_.eye);
}

void RenderClient::writeSnapshot(const std::string& name) {
  const std::filesystem::path folder = options_.snapshot_dir.empty() ? "." : options_.snapshot_dir;
  writePng((folder / (name + ".png")).string(), snapshot(), pictureText(*replica_, options_));
}

Image RenderClient::snapshot() {
  if (!options_.panel_snapshots) return renderer_->readImage();
  return renderer_->readPanel(display_size_.width * eyeCount(eyes_), display_size_.height);
}

/// As long as it was to be seen: a picture stands in for those that this machine was too slow to draw, up to
/// a second of them. A film that cannot go on ends; what is drawn goes on.
void RenderClient::addToVideo(std::uint64_t number) {
  if (!video_ || !video_fault_.empty()) return;
  const std::uint64_t frames = pacing_.framesSince(number);
  const auto second = static_cast<std::uint64_t>(std::ceil(1.0 / pacing_.secondsBetween()));
  try {
    video_->write(snapshot(), std::clamp<std::uint64_t>(frames, 1, second));
  } catch (const std::exception& e) {
    video_fault_ = e.what();
    overlay_.notify(video_fault_, now());
  }
}

void RenderClient::endVideo() {
  if (!video_ || !video_fault_.empty()) return;
  try {
    video_->finish();
  } catch (const std::exception& e) {
    video_fault_ = e.what();
  }
}

bool RenderClient::finished() const {
  if (stopRequested() || closed_) return true;
  if (options_.frames > 0 && frames_ >= options_.frames) return true;
  return options_.duration_s > 0.0 && static_cast<double>(now() - started_) >= options_.duration_s * 1e9;
}

ClientStats RenderClient::stats() const {
  ClientStats stats;
  stats.frames = frames_;
  stats.frame_ms = spread(pacing_.drawing(), kMillisecond);
  stats.motion_to_present_ms = spread(pacing_.motionToPresent(), kMillisecond);
  stats.late_ms = spread(pacing_.lateness(), kMillisecond);
  stats.eye = options_.eye;
  stats.scene = replica_->session().scene.name;
  stats.renderer = renderer_->rendererName();
  stats.width = views_.empty() ? options_.width : views_.front().width;
  stats.height = views_.empty() ? options_.height : views_.front().height;
  stats.samples = renderer_->samples();
  stats.hash_mismatches = replica_->hashMismatches();
  stats.recompilations = recompilations_;
  stats.found_to_move = found_to_move_;
  stats.link = link_.stats();
  if (first_frame_) {
    stats.first_frame_ms = static_cast<double>(*first_frame_ - started_) / 1e6;
    const auto span_ns = static_cast<double>(last_frame_ - *first_frame_);
    stats.fps = stats.frames > 1 ? static_cast<double>(stats.frames - 1) * 1e9 / span_ns : 0.0;
    stats.motion_age_ms = static_cast<double>(now() - newest_arrived_) / 1e6;
  }
  return stats;
}

}  // namespace coherency
