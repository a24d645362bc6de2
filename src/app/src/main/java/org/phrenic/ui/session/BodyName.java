package org.phrenic.ui.session;

import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;

/** Names the body of a window, so that the windows of two persons are told apart. */
public final class BodyName {
    private static final String VIRTUAL = "virtual/";

    private BodyName() {}

    /** The folder of a body, or the kind of a virtual one; empty for the virtual man, who is there at first. */
    public static String of(Scenario scenario) {
        String anatomy = scenario.anatomy();
        if (anatomy.equals(RunSettings.VIRTUAL_MAN)) {
            return "";
        }
        String label = RunSettings.bodyLabel(anatomy);
        return label.startsWith(VIRTUAL) ? label.substring(VIRTUAL.length()).replace('-', ' ') : label;
    }
}
