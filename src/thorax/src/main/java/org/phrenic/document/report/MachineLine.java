package org.phrenic.document.report;

/** The line of a report that names the machine and the Java version on which its numbers were made. */
public final class MachineLine {
    private MachineLine() {}

    /** Operating system, architecture, number of processors and Java version, as one sentence. */
    public static String text() {
        return "Machine: " + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ", "
                + Runtime.getRuntime().availableProcessors() + " processors, Java " + System.getProperty("java.version")
                + ".";
    }
}
