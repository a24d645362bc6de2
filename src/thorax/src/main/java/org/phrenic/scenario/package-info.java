/**
 * Scenarios: the registry of all settings, the scenario and its file, and scheduled changes. Text is parsed into
 * setting values only here.
 */
package org.phrenic.scenario;
