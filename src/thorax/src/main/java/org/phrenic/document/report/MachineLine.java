package org.phrenic.document.report;

/** The line of a report that names the machine and the Java version on which its numbers were made. */
public final class MachineLine {
    private MachineLine() {}

    /** Operating system, architecture, number of processors and Java version, as one sentence. */
    public static String text() {
        int processors = Runtime.getRuntime().availableProcessors();
        return "Machine: " + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ", "
                + processors + (processors == 1 ? " processor, Java " : " processors, Java ")
                + System.getProperty("java.version")
                + ".";
    }
}
