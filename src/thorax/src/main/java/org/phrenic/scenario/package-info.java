/** What is simulated: a scenario, its file, its defaults and its changes. */
package org.phrenic.scenario;
