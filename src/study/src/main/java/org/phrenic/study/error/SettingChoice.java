package org.phrenic.study.error;

import static org.phrenic.file.Numbers.format;

import org.phrenic.file.Numbers;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;

/**
 * The cheapest measured setting that keeps an error.
 *
 * @param row of the setting
 * @param mostMm rms error of the diaphragm that was asked for, mm
 */
public record SettingChoice(ErrorTable.Row row, double mostMm) {
    private static final int STATED_DECIMALS = 6;

    /** The setting. */
    public SolverSettings settings() {
        return row.point().settings();
    }

    /**
     * The choice and its reason.
     *
     * @param measured a scenario with the body that the table was measured with
     */
    public String sentence(Scenario measured) {
        String reached = format(
                "%s; measured %.3g mm rms (%.2g %% of the excursion), %.3g mm at worst",
                settings().label(),
                row.point().rmsMm(),
                row.rmsPercent(),
                row.point().maxMm());
        return "For an error of at most " + number(mostMm) + " mm rms of the diaphragm: " + reached + ", on "
                + SolverSettings.number(row.untilS()) + " s of a " + row.preset() + " breath of " + body(measured)
                + " at " + row.resolution() + " resolution.";
    }

    /** An error in a sentence, mm. */
    static String number(double mm) {
        return Numbers.trimmed(mm, STATED_DECIMALS);
    }

    /** The body of a scenario in a sentence. */
    static String body(Scenario scenario) {
        String label = RunSettings.bodyLabel(scenario.anatomy());
        return "the " + (scenario.isVirtual() ? label.replace('/', ' ').replace('-', ' ') : "body " + label);
    }
}
