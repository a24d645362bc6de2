package org.phrenic.study.scan;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.BadInputException;

/** Number of voxels of a volume along its three directions. */
public record ScanSize(int columns, int rows, int slices) {
    private static final Pattern TEXT = Pattern.compile("(\\d{1,4})x(\\d{1,4})x(\\d{1,4})");
    private static final int LEAST = 16;
    private static final long MOST_VOXELS = 1_000_000_000L;

    /** @throws BadInputException if the text is not like {@code 512x512x600}, or the volume too small or too large */
    public static ScanSize parse(String text) {
        Matcher matcher = TEXT.matcher(text);
        if (matcher.matches()) {
            int[] n = new int[3];
            for (int d = 0; d < 3; d++) {
                n[d] = Integer.parseInt(matcher.group(d + 1));
            }
            boolean large = (long) n[0] * n[1] * n[2] > MOST_VOXELS;
            if (!large && Math.min(n[0], Math.min(n[1], n[2])) >= LEAST) {
                return new ScanSize(n[0], n[1], n[2]);
            }
        }
        throw new BadInputException("--size: found '" + text
                + "', expected columns, rows and slices such as 512x512x600, 16 or more each, 1e9 voxels at most");
    }

    @Override
    public String toString() {
        return columns + " x " + rows + " x " + slices;
    }
}
