#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/input/ShipFile.h"
#include "demos/cutwater/output/ShipListing.h"

namespace cutwater::command {

void hydrostatics(const std::string& path, const std::string& out) {
  const ShipFile ship = readShipFile(path, Balance::Needed);
  Listing rows;
  listHydrostatics(rows, ship.particulars, ship.hydrostatics);
  rows.write(out);
}

}  // namespace cutwater::command
