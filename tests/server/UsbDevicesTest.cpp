#include <string>

#include <gtest/gtest.h>
#include <umockdev.h>

#include "motion_server/device/UsbDevices.h"

// Runs under umockdev-wrapper: the test bed's /sys and /dev take the place of the machine's.

namespace coherency {
namespace {

/// A full-speed device with one vendor-specific interface, as an encoder box would show itself: device,
/// configuration, interface and one interrupt-IN endpoint descriptor (USB 2.0, chapter 9).
#define DESCRIPTORS                      \
  "12010002FF00004066663412000100000001" \
  "090219000101008032"                   \
  "0904000001FF000000"                   \
  "0705810340000A"
constexpr char kDevice[] =
    "P: /devices/pci0000:00/0000:00:14.0/usb1/1-2\n"
    "N: bus/usb/001/007=" DESCRIPTORS
    "\n"
    "E: DEVNAME=/dev/bus/usb/001/007\n"
    "E: DEVTYPE=usb_device\n"
    "E: SUBSYSTEM=usb\n"
    "E: BUSNUM=001\n"
    "E: DEVNUM=007\n"
    "E: MAJOR=189\n"
    "E: MINOR=6\n"
    "A: busnum=1\\n\n"
    "A: devnum=7\\n\n"
    "A: bConfigurationValue=1\\n\n"
    "A: speed=12\\n\n"
    "H: descriptors=" DESCRIPTORS "\n";

TEST(UsbDevices, ListsTheDeviceOnTheBus) {
  UMockdevTestbed* testbed = umockdev_testbed_new();
  ASSERT_TRUE(umockdev_in_mock_environment()) << "run through umockdev-wrapper";
  GError* error = nullptr;
  ASSERT_TRUE(umockdev_testbed_add_from_string(testbed, kDevice, &error)) << error->message;
  const auto devices = listUsbDevices();
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_EQ(devices[0].vendor_id, 0x6666);
  EXPECT_EQ(devices[0].product_id, 0x1234);
  EXPECT_EQ(devices[0].bus, 1);
  EXPECT_EQ(devices[0].address, 7);
  EXPECT_NE(describe(devices[0]).find("bus 001 address 007  6666:1234"), std::string::npos)
      << describe(devices[0]);
  g_object_unref(testbed);
}

TEST(UsbDevices, AnEmptyBusIsAnEmptyListOrASayingError) {
  UMockdevTestbed* testbed = umockdev_testbed_new();
  try {
    EXPECT_TRUE(listUsbDevices().empty());
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("USB"), std::string::npos);
  }
  g_object_unref(testbed);
}

}  // namespace
}  // namespace coherency
