#pragma once
#include "plugin/Ship.h"

CUTWATER_PLUGIN_BEGIN

/// Refuses settings that are not finite or outside what a ship can do, before anything is made of
/// them. The bounds are wide: they are to catch a wrong unit, a number that was never set, and what
/// would end the simulation in its first tick.
/// @param function  begins the message, which names field, value and bounds.
/// @throws HydroError ValueOutOfRange.
void checkSettings(const ShipSettings& settings, const char* function);
void checkStart(const ShipStart& start, const char* function);
/// The sea's gravity is that of a database [m/s²] to three digits; calm water has none.
void checkSea(const SeaState& sea, double right, const char* function);
void checkOrder(const SpeedKeeper& order, const char* function);
void checkOrder(const CourseKeeper& order, const char* function);

CUTWATER_PLUGIN_END
