#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/body/Rig.h"
#include "common/world/SceneDescription.h"
#include "common/world/WorldState.h"

namespace coherency {

/// Everything a motion server needs to know (configs/servers/).
struct ServerConfig {
  std::string scenes_folder;  ///< where scenes are found by name: the file's ../scenes, else where installed
  std::string scene_file;
  SceneDescription scene;
  Rig rig;
  std::vector<std::string> rig_defaults;  ///< measures that the rig's file leaves out
  Mode mode = Mode::Operator;             ///< that the session begins in
  std::uint64_t world_seed = 0;           ///< of what is scattered; 0: as the scene has it
  std::string address = "127.0.0.1";      ///< numeric (listenAddress())
  std::uint16_t port = 7430;
  int redundancy = 2;  ///< earlier samples in each packet, 0..7
  int max_clients = 64;
  std::string encoding = "exact";  ///< of samples: exact, compact, or auto: compact within the budgets below
  std::string multicast_address;   ///< empty: every client is sent its own
  std::uint16_t multicast_port = 0;
  bool discovery = true;         ///< answers who searches for servers
  double frames_hz = 62.5;       ///< pictures a second, the same for all eyes
  double least_margin_ms = 2.0;  ///< from a frame's moment to its being seen, at least and at most
  double most_margin_ms = 100.0;
  std::string prediction = "kalman";
  double horizon_ms = 80.0;  ///< nothing is predicted farther than this
  double hand_mm = 0.0;      ///< budgets of what encoding may add; 0: none
  double view_px = 0.0;
  double rate_hz = 1000.0;
  std::string master = "simulated";  ///< simulated or replay
  std::uint64_t seed = 1;            ///< of the simulated operator
  std::string recording;             ///< CSV, for replay
  bool loop = true;
  bool seated = true;  ///< recorded head moved to the rig's sitting height; false: as recorded
};

/// Takes another scene, by a name in scenes_folder or a path. Throws ConfigError.
void setScene(ServerConfig& config, const std::string& scene);

/// Paths in the file are relative to the file. Throws ConfigError.
ServerConfig readServerConfig(const std::string& path);

}  // namespace coherency
