#include <string>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/layers.h"

namespace fluidymation {

void inLayer(const std::string& name, const std::function<void()>& step) {
  const std::string layer = "layer " + name + ": ";
  try {
    step();
  } catch (const Faults& faults) {
    std::vector<std::string> lines;
    for (const std::string& line : faults.lines()) lines.push_back(layer + line);
    throw Faults(lines);
  } catch (const UsageError& error) {
    throw UsageError(layer + error.what());
  } catch (const Error& error) {
    throw Error(layer + error.what());
  } catch (const Interrupted& stop) {
    throw Interrupted(layer + stop.what(), stop.canResume());
  }
}

}  // namespace fluidymation
