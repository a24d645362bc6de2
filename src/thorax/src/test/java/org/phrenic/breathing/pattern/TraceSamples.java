package org.phrenic.breathing.pattern;

/** Recordings that tests write and read. */
public final class TraceSamples {
    private TraceSamples() {}

    /** Nine seconds of breaths of 4 s as CSV; the lowest sample before the first breath is at 1 s. */
    public static String fromOneSecondOn() {
        StringBuilder csv = new StringBuilder("time_s,amplitude\n");
        for (int i = 0; i <= 90; i++) {
            csv.append(i / 10.0)
                    .append(',')
                    .append(-Math.cos(Math.PI * (i - 10) / 20))
                    .append('\n');
        }
        return csv.toString();
    }

    /** Eighteen seconds of breaths of 4 s as CSV, from half way up; end-expirations at 3, 7, 11 and 15 s. */
    public static String fromHalfwayUpToHalfwayDown() {
        StringBuilder csv = new StringBuilder("time_s,amplitude\n");
        for (int i = 0; i <= 180; i++) {
            csv.append(i / 10.0)
                    .append(',')
                    .append(-Math.cos(Math.PI * (i + 10) / 20))
                    .append('\n');
        }
        return csv.toString();
    }
}
