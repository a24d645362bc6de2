package org.phrenic.cli;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.phrenic.format.BadInputException;
import org.phrenic.scene.Shot;
import org.phrenic.scene.View;
import picocli.CommandLine.Option;

/** From where and how large pictures are taken. */
final class ShotOptions {
    private static final double LEAST_ZOOM = 0.1;
    private static final double MOST_ZOOM = 50;

    @Option(
            names = "--view",
            paramLabel = "NAME[,NAME...]",
            description = "anterior, posterior, left, right, superior, inferior; or all. Default: anterior.")
    private String views = "anterior";

    @Option(names = "--size", paramLabel = "WxH", description = "Pixels, each 16 to 8192. Default: 1000x1000.")
    private String size = "1000x1000";

    @Option(names = "--orthographic", description = "Parallel projection, with a ruler; else perspective.")
    private boolean orthographic;

    @Option(names = "--zoom", paramLabel = "F", description = "Enlarge about the middle, 0.1 to 50.")
    private String zoom = "1";

    @Option(names = "--no-annotations", description = "No letters, figure, scale, time or notice.")
    private boolean bare;

    /** A shot for each view asked for. */
    List<Shot> shots(String title) {
        String[] sides = size.toLowerCase(java.util.Locale.ROOT).split("x", -1);
        if (sides.length != 2) {
            throw new BadInputException("--size: found '" + size + "', expected WxH such as 1000x800");
        }
        int width = OptionNumbers.whole("--size " + size, sides[0], Shot.SMALLEST, Shot.LARGEST);
        int height = OptionNumbers.whole("--size " + size, sides[1], Shot.SMALLEST, Shot.LARGEST);
        double factor = OptionNumbers.number("--zoom", zoom, LEAST_ZOOM, MOST_ZOOM);
        List<Shot> shots = new ArrayList<>();
        for (View view : views()) {
            shots.add(new Shot(view, width, height, orthographic, factor, !bare, title));
        }
        return shots;
    }

    private Set<View> views() {
        if (views.equals("all")) {
            return new LinkedHashSet<>(List.of(View.values()));
        }
        Set<View> found = new LinkedHashSet<>();
        for (String label : OptionNumbers.parts(views)) {
            try {
                found.add(View.of(label));
            } catch (IllegalArgumentException unknown) {
                throw new BadInputException("--view: " + unknown.getMessage(), unknown);
            }
        }
        return found;
    }
}
