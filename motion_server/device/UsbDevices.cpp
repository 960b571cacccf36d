#include "motion_server/device/UsbDevices.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <tuple>

#include <libusb.h>

namespace coherency {

namespace {

[[noreturn]] void fail(const std::string& what, int code) {
  throw std::runtime_error("USB: " + what + ": " + libusb_strerror(static_cast<libusb_error>(code)) + " (" +
                           libusb_error_name(code) + "); is /dev/bus/usb there and readable?");
}

class Context {
 public:
  Context() {
    const int code = libusb_init(&context_);
    if (code != LIBUSB_SUCCESS) fail("cannot be initialised", code);
  }
  ~Context() { libusb_exit(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  libusb_context* get() const { return context_; }

 private:
  libusb_context* context_ = nullptr;
};

std::string text(libusb_device_handle* handle, std::uint8_t which, std::string& problem) {
  if (which == 0) return {};
  std::array<unsigned char, 256> bytes{};
  const int length =
      libusb_get_string_descriptor_ascii(handle, which, bytes.data(), static_cast<int>(bytes.size()));
  if (length >= 0) return {bytes.begin(), bytes.begin() + length};
  problem = libusb_strerror(static_cast<libusb_error>(length));
  return {};
}

void readTexts(libusb_device* device, const libusb_device_descriptor& descriptor, UsbDeviceInfo& info) {
  libusb_device_handle* opened = nullptr;
  const int code = libusb_open(device, &opened);
  if (code != LIBUSB_SUCCESS) {
    info.problem = libusb_strerror(static_cast<libusb_error>(code));
    return;
  }
  const std::unique_ptr<libusb_device_handle, void (*)(libusb_device_handle*)> handle(opened, libusb_close);
  info.manufacturer = text(opened, descriptor.iManufacturer, info.problem);
  info.product = text(opened, descriptor.iProduct, info.problem);
  info.serial = text(opened, descriptor.iSerialNumber, info.problem);
}

UsbDeviceInfo inspect(libusb_device* device) {
  UsbDeviceInfo info;
  info.bus = libusb_get_bus_number(device);
  info.address = libusb_get_device_address(device);
  libusb_device_descriptor descriptor{};
  const int code = libusb_get_device_descriptor(device, &descriptor);
  if (code != LIBUSB_SUCCESS) {
    info.problem = libusb_strerror(static_cast<libusb_error>(code));
    return info;
  }
  info.vendor_id = descriptor.idVendor;
  info.product_id = descriptor.idProduct;
  readTexts(device, descriptor, info);
  return info;
}

}  // namespace

std::vector<UsbDeviceInfo> listUsbDevices() {
  const Context context;
  libusb_device** list = nullptr;
  const ssize_t count = libusb_get_device_list(context.get(), &list);
  if (count < 0) fail("devices cannot be listed", static_cast<int>(count));
  const std::unique_ptr<libusb_device*, void (*)(libusb_device**)> owner(
      list, [](libusb_device** devices) { libusb_free_device_list(devices, 1); });
  std::vector<UsbDeviceInfo> devices;
  for (ssize_t i = 0; i < count; ++i) devices.push_back(inspect(list[i]));
  std::sort(devices.begin(), devices.end(), [](const UsbDeviceInfo& a, const UsbDeviceInfo& b) {
    return std::tie(a.bus, a.address) < std::tie(b.bus, b.address);
  });
  return devices;
}

std::string describe(const UsbDeviceInfo& device) {
  std::array<char, 64> ids{};
  std::snprintf(ids.data(), ids.size(), "bus %03d address %03d  %04x:%04x", device.bus, device.address,
                device.vendor_id, device.product_id);
  std::string line = ids.data();
  for (const std::string& part : {device.manufacturer, device.product}) {
    if (!part.empty()) line += "  " + part;
  }
  if (!device.serial.empty()) line += "  serial " + device.serial;
  if (!device.problem.empty()) line += "  (names not read: " + device.problem + ")";
  return line;
}

}  // namespace coherency
