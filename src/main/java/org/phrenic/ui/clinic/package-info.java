/** Parts of the clinician's door that know of rehearsals and nothing of the window: sections, verdicts, report cards. */
package org.phrenic.ui.clinic;
