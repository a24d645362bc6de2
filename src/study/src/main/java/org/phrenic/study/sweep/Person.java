package org.phrenic.study.sweep;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A person of a cohort. As text: {@code male 35 y 1.75 m 75 kg}.
 *
 * @param sex {@code male} or {@code female}
 * @param ageYears age, years
 * @param heightM stature, m
 * @param weightKg weight, kg
 */
record Person(String sex, int ageYears, double heightM, double weightKg) {
    /** Names of {@link #traits}. */
    static final List<String> TRAITS = List.of("sex", "age_y", "height_m", "weight_kg");

    private static final Pattern FORM =
            Pattern.compile("(male|female) (\\d{1,3}) y (\\d(?:\\.\\d{1,3})?) m (\\d{1,3}(?:\\.\\d)?) kg");

    /** @throws IllegalArgumentException with one sentence, if the text is no person */
    static Person parse(String text) {
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            throw new IllegalArgumentException(
                    "found the person '" + text + "', expected sex, age, height and weight: male 35 y 1.75 m 75 kg");
        }
        return new Person(
                form.group(1),
                Integer.parseInt(form.group(2)),
                Double.parseDouble(form.group(3)),
                Double.parseDouble(form.group(4)));
    }

    /** The person as text, with height in cm and weight in 0.1 kg. */
    String text() {
        return String.format(Locale.ROOT, "%s %d y %.2f m %.1f kg", sex, ageYears, heightM, weightKg);
    }

    /** Sex, age, height and weight as cells of a table. */
    List<String> traits() {
        return List.of(sex, String.valueOf(ageYears), String.valueOf(heightM), String.valueOf(weightKg));
    }

    /** Body mass index, kg/m^2. */
    double massIndex() {
        return weightKg / (heightM * heightM);
    }
}
