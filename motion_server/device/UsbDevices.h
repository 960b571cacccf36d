#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace coherency {

struct UsbDeviceInfo {
  std::uint16_t vendor_id = 0;
  std::uint16_t product_id = 0;
  int bus = 0;
  int address = 0;
  /// Empty where the device has none; `problem` says why where they could not be read (no permission, say).
  std::string manufacturer;
  std::string product;
  std::string serial;
  std::string problem;
};

/// Every device on this machine's USB buses, by bus and address. Throws std::runtime_error saying what failed
/// where USB is not to be had.
std::vector<UsbDeviceInfo> listUsbDevices();

/// One line, as `motion_server --list-devices` prints it.
std::string describe(const UsbDeviceInfo& device);

}  // namespace coherency
