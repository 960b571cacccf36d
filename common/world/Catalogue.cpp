#include "common/world/Catalogue.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "common/objects/Corridor.h"
#include "common/objects/Finish.h"
#include "common/objects/Grid.h"
#include "common/objects/Laboratory.h"
#include "common/objects/MeetingRoom.h"
#include "common/objects/Office.h"
#include "common/objects/Outdoors.h"
#include "common/objects/Targets.h"

namespace coherency {

namespace {

using Made = std::unique_ptr<VRObject>;

/// For classes that need nothing to be made.
template <class Kind>
Made plain(const ObjectPlacement&, Stage&) {
  return std::make_unique<Kind>();
}

std::optional<std::uint32_t> colourFrom(const std::string& text) {
  std::uint32_t colour = 0;
  const char* end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  const auto read = std::from_chars(text.data() + 1, end, colour, 16);
  return read.ec == std::errc{} && read.ptr == end ? std::optional(colour) : std::nullopt;
}

std::uint32_t colourOf(const ObjectPlacement& placement, std::uint32_t fallback) {
  return colourFrom(placement.colour).value_or(fallback);
}

Made block(const ObjectPlacement& placement, Stage&) {
  return std::make_unique<Block>(placement.name, colourOf(placement, 0xC8433A));
}

/// For classes made in one colour.
template <class Kind, std::uint32_t own>
Made coloured(const ObjectPlacement& placement, Stage&) {
  return std::make_unique<Kind>(colourOf(placement, own));
}

Made lamp(const ObjectPlacement&, Stage&) {
  return std::make_unique<CeilingLamp>(1.2, 0.5, 2.4);
}

Made floor(const ObjectPlacement&, Stage&) {
  return std::make_unique<TiledFloor>(8.0, 8.0, 0.5, 0xC2B49F, 0xB1A28C, 0.12);
}

Made grid(const ObjectPlacement& placement, Stage&) {
  return std::make_unique<Grid>(placement.count);
}

Made targets(const ObjectPlacement&, Stage& stage) {
  return std::make_unique<Targets>(stage.rig, stage.human);
}

constexpr CatalogueEntry kCatalogue[] = {
    {"laboratory", "room 7 m by 6 m with windows ahead, furniture, and a sliding door to the right",
     plain<Laboratory>},
    {"corridor", "corridor 2.2 m by 16.7 m that joins laboratory, office and meeting room", plain<Corridor>},
    {"office", "room 4.6 m by 5.2 m with two desks, and a sliding door to the left", plain<Office>},
    {"meeting room", "room 6.2 m by 5.2 m with a long table, and a sliding door to the right",
     plain<MeetingRoom>},
    {"outdoors", "what is to be seen through the building's windows", plain<Outdoors>},
    {"floor", "tiles, 8 m by 8 m about the origin", floor},
    {"table", "work table 1.4 m by 0.7 m, 0.72 m high", plain<Table>},
    {"desk", "desk 1.5 m by 0.68 m, 0.74 m high, with drawers", plain<Desk>},
    {"meeting table", "table for eight, 2.8 m by 1.1 m, 0.74 m high", plain<MeetingTable>},
    {"workbench", "workshop's bench 2.4 m by 0.7 m, 0.86 m high, with shelves", plain<Workbench>},
    {"chair", "upholstered chair with four legs", coloured<Chair, 0xB8704A>, true},
    {"swivel chair", "desk chair on castors", coloured<SwivelChair, 0x4E6472>, true},
    {"armchair", "low and soft", coloured<Armchair, 0x52707A>, true},
    {"bench", "wooden bench 1.5 m long", plain<Bench>},
    {"bookshelf", "open shelf 1.2 m wide, 2 m high, with books", plain<Bookshelf>},
    {"cabinet", "low cabinet 1.2 m wide with two doors", plain<Cabinet>},
    {"rack", "steel cabinet with electronics", plain<Rack>},
    {"coat stand", "pole with a coat", plain<CoatStand>},
    {"plant", "potted plant about 1 m high", plain<Plant>},
    {"tree", "round tree about 4 m high, in daylight", plain<Tree>},
    {"monitor", "computer screen with keyboard, to stand on a desk", plain<Monitor>},
    {"computer", "to stand under a desk", plain<Computer>},
    {"oscilloscope", "measuring instrument", plain<Oscilloscope>},
    {"globe", "globe on a foot", plain<Globe>},
    {"mug", "mug of coffee", coloured<Mug, 0xE9E3D6>, true},
    {"tool box", "steel box with a handle", coloured<ToolBox, finish::kRed>, true},
    {"waste bin", "bin to stand beside a desk", plain<WasteBin>},
    {"whiteboard", "board 1.84 m wide; origin in its middle, at the wall", plain<Whiteboard>},
    {"notice board", "cork board 1.5 m wide; origin in its middle, at the wall", plain<NoticeBoard>},
    {"wall screen", "screen 1.64 m wide; origin in its middle, at the wall", plain<WallScreen>},
    {"poster", "print in a frame; origin in its middle, at the wall", coloured<Poster, 0x2F5D73>, true},
    {"wall clock", "clock that ticks; origin in its middle, at the wall", plain<WallClock>},
    {"fire extinguisher", "on a bracket; origin in its middle, at the wall", plain<FireExtinguisher>},
    {"lamp", "shining panel 1.2 m by 0.5 m; origin at the ceiling it hangs under", lamp},
    {"standing lamp", "reading lamp 1.6 m high", plain<StandingLamp>},
    {"desk lamp", "to stand on a desk", plain<DeskLamp>},
    {"block", "cube of 55 mm to build with; origin in its centre", block, true},
    {"grid", "any number of boxes a metre apart, for measuring", grid, false, true},
    {"targets", "markers at known distances and on the hand", targets},
};

}  // namespace

std::span<const CatalogueEntry> catalogue() {
  return kCatalogue;
}

const CatalogueEntry* findKind(std::string_view kind) {
  const auto found = std::find_if(std::begin(kCatalogue), std::end(kCatalogue),
                                  [&](const CatalogueEntry& entry) { return entry.kind == kind; });
  return found == std::end(kCatalogue) ? nullptr : found;
}

std::optional<PlacementFault> faultOf(const ObjectPlacement& placement) {
  const std::string& kind = placement.kind;
  const CatalogueEntry* entry = findKind(kind);
  if (entry == nullptr) {
    std::string known;
    for (const CatalogueEntry& e : kCatalogue) known += (known.empty() ? "" : ", ") + std::string(e.kind);
    return PlacementFault{"kind", "there is no kind '" + kind + "'; there are " + known};
  }
  if (!placement.colour.empty() && !entry->coloured)
    return PlacementFault{"colour", "a " + kind + " comes in no colours"};
  if (!placement.colour.empty() && !colourFrom(placement.colour))
    return PlacementFault{"colour", "\"" + placement.colour + "\" is no colour; write it as \"#c8433a\""};
  if (placement.count != 0 && !entry->counted)
    return PlacementFault{"count", "a " + kind + " takes no count"};
  if (entry->counted && placement.count < 1)
    return PlacementFault{
        "count", "a " + kind + " needs a count of 1 or more: count = 1000, or after the scene's name, as \"" +
                     kind + ":1000\""};
  return std::nullopt;
}

std::unique_ptr<VRObject> makeObject(const ObjectPlacement& placement, Stage& stage) {
  if (const auto fault = faultOf(placement))
    throw std::invalid_argument("object '" + placement.name + "': " + fault->what);
  const CatalogueEntry* entry = findKind(placement.kind);
  std::unique_ptr<VRObject> object = entry->make(placement, stage);
  object->setName(placement.name);
  object->setTransform(transform(placement.place));
  return object;
}

}  // namespace coherency
