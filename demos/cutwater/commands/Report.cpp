#include "demos/cutwater/commands/Commands.h"
#include "demos/cutwater/output/OutputFile.h"
#include "demos/report_page/Page.h"

namespace cutwater::command {

void report(const std::string& database, const std::vector<std::string>& runs,
            const std::string& out) {
  const bool dataAlone = out.ends_with(".json");
  if (!dataAlone) page::requirePage();
  const std::string data = page::pageData(database, runs);
  writeText(dataAlone ? data + "\n" : page::pageWith(data), out);
}

}  // namespace cutwater::command
