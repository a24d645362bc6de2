package org.phrenic.cli.option;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.access.imaging.Fluoroscope;
import org.phrenic.file.BadInputException;
import org.phrenic.scene.RadiographRenderer.View;
import picocli.CommandLine.Option;

/** Options for radiographs. */
public final class RadiographOptions {
    private static final double DEFAULT_FIELD_MM = 600;

    @Option(
            names = "--xray",
            paramLabel = "LAO/CRAN[,...]",
            description = "Radiographs by a C-arm instead of views: degrees toward the left (RAO negative) and toward"
                    + " the head (caudal negative), such as 0/0,30/0,-30/20. Needs no OpenGL.")
    private String angles;

    @Option(names = "--photon-energy", paramLabel = "KEV", description = "Photon energy, 40 to 80. Default: 60.")
    private String energy;

    @Option(names = "--detector", paramLabel = "MM", description = "Width of the detector, 50 to 2000. Default: 600.")
    private String field;

    /** Whether radiographs are wanted. */
    public boolean given() {
        return angles != null;
    }

    /** Photon energy, keV. */
    public double energyKev() {
        return energy == null ? Fluoroscope.ENERGY_KEV : OptionValues.number("--photon-energy", energy, 40, 80);
    }

    /**
     * Checks all values.
     *
     * @throws BadInputException if one is out of range, or an option of radiographs is given without any
     */
    public void validate() {
        if (!given() && (energy != null || field != null)) {
            throw new BadInputException((energy != null ? "--photon-energy" : "--detector")
                    + ": found without --xray, expected it with the angles of a C-arm");
        }
        List<View> views = views(1, 1);
        OptionValues.requireApart(
                "--xray",
                views.stream().map(RadiographOptions::fileName).toList(),
                views.stream()
                        .map(v -> v.leftObliqueDeg() + "/" + v.cranialDeg())
                        .toList(),
                "angles that differ by 0.001 degrees or more");
        energyKev();
    }

    /** Beginning of the file name of a radiograph: its angles, to a thousandth of a degree. */
    public static String fileName(View view) {
        return "xray_" + View.angle(view.leftObliqueDeg()) + "_" + View.angle(view.cranialDeg());
    }

    /** The views that are asked for, each once, of a size in pixels. */
    public List<View> views(int width, int height) {
        double fieldMm = field == null ? DEFAULT_FIELD_MM : OptionValues.number("--detector", field, 50, 2000);
        List<View> views = new ArrayList<>();
        for (String text : angles == null ? List.<String>of() : OptionValues.split(angles)) {
            String[] pair = text.split("/", -1);
            if (pair.length != 2) {
                throw new BadInputException("--xray: found '" + text + "', expected LAO/CRAN such as 30/0");
            }
            double left = OptionValues.number("--xray " + text, pair[0], -180, 180);
            double cranial = OptionValues.number("--xray " + text, pair[1], -90, 90);
            views.add(new View(left, cranial, fieldMm, width, height));
        }
        return views.stream().distinct().toList();
    }
}
