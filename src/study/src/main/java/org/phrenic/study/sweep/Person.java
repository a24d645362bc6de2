package org.phrenic.study.sweep;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.phrenic.file.Numbers;

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

    private static final int LEAST_YEARS = 18;
    private static final int MOST_YEARS = 110;
    private static final double LEAST_M = 1.2;
    private static final double MOST_M = 2.3;
    private static final double LEAST_KG = 30;
    private static final double MOST_KG = 300;

    private static final Pattern FORM =
            Pattern.compile("(male|female) (\\d{1,3}) y (\\d(?:\\.\\d{1,3})?) m (\\d{1,3}(?:\\.\\d)?) kg");

    /** @throws IllegalArgumentException with one sentence, if the text is no person */
    static Person parse(String text) {
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            throw new IllegalArgumentException(
                    "found the person '" + text + "', expected sex, age, height and weight: male 35 y 1.75 m 75 kg");
        }
        Person person = new Person(
                form.group(1),
                Integer.parseInt(form.group(2)),
                Double.parseDouble(form.group(3)),
                Double.parseDouble(form.group(4)));
        if (!person.isAdult()) {
            throw new IllegalArgumentException(Numbers.format(
                    "found the person '%s', expected an adult of %d to %d y, %.1f to %.1f m and %.0f to %.0f kg",
                    text, LEAST_YEARS, MOST_YEARS, LEAST_M, MOST_M, LEAST_KG, MOST_KG));
        }
        return person;
    }

    /** Whether age, height and weight are those of adults, also very small and very heavy ones. */
    private boolean isAdult() {
        return ageYears >= LEAST_YEARS
                && ageYears <= MOST_YEARS
                && heightM >= LEAST_M
                && heightM <= MOST_M
                && weightKg >= LEAST_KG
                && weightKg <= MOST_KG;
    }

    /** The person as text, with height in cm and weight in 0.1 kg. */
    String text() {
        return Numbers.format("%s %d y %.2f m %.1f kg", sex, ageYears, heightM, weightKg);
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
