/** From a patient's scan to a thorax: labels become surfaces, and what the scan lacks comes from the virtual thorax. */
package org.phrenic.patient;
