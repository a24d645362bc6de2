package org.phrenic.cli.option;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import picocli.CommandLine.Option;

/** Options for view and size of pictures. */
public final class PictureOptions {
    /** Options that a radiograph does not read. */
    public static final Set<String> OF_DRAWINGS = Set.of("--view", "--orthographic", "--zoom");

    /** All options. */
    public static final Set<String> NAMES = Set.of("--view", "--size", "--orthographic", "--zoom", "--no-annotations");

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
    private boolean noAnnotations;

    public List<PictureSettings> settings(String title) {
        String[] sides = size.toLowerCase(Locale.ROOT).split("x", -1);
        if (sides.length != 2) {
            throw new BadInputException("--size: found '" + size + "', expected WxH such as 1000x800");
        }
        int width = side(sides[0]);
        int height = side(sides[1]);
        double factor = OptionValues.number("--zoom", zoom, LEAST_ZOOM, MOST_ZOOM);
        List<AnatomicalView> all = List.of(AnatomicalView.values());
        Stream<AnatomicalView> chosen = views.equals("all")
                ? all.stream()
                : OptionValues.split(views).stream().map(label -> OptionValues.choice("--view", label, all));
        return chosen.distinct()
                .map(v -> new PictureSettings(v, width, height, orthographic, factor, !noAnnotations, title))
                .toList();
    }

    private int side(String pixels) {
        return OptionValues.integer("--size " + size, pixels, PictureSettings.MIN_SIZE, PictureSettings.MAX_SIZE);
    }
}
