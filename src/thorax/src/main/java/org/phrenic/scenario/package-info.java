/**
 * What is to be simulated: the registry of all settings, the scenario, its file and the changes made while it runs. The
 * only place where text becomes values of settings.
 */
package org.phrenic.scenario;
