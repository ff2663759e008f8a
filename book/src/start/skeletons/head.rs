use common::rtweekend::*;
