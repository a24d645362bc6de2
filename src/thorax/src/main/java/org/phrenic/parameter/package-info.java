/**
 * Declarations of the settings of a scenario: key, name, unit, range, default and effect. The parts of a simulation
 * declare the settings that they use. Scenario files, {@code --set}, sliders, searches and {@code docs/parameters.md}
 * are generated from the declarations. May use breathing's ramp and YAML. Independent of scenes.
 */
package org.phrenic.parameter;
