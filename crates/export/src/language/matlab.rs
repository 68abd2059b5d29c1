//! MATLAB and Octave.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "matlab",
    aliases: &["m", "octave"],
    title: "MATLAB and Octave, a function",
    file: "NAME_epsilon.m",
    comment: "% ",
    rows: Rows { before: "        ", between: ", ", after: "\n", suffix: "" },
    reserved: &[],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#"function [epsilon, loss, slope] = {NAME}_epsilon(u, g_star)
{HEAD}
% Save it as {FILE}. For arrays of any shape:
%     epsilon = {NAME}_epsilon(u)                   the coefficient of restitution
%     [epsilon, loss, slope] = {NAME}_epsilon(u)    1 - epsilon with all its digits, d epsilon/d u
%     [...] = {NAME}_epsilon(velocity, g_star)      of the size of a velocity; both in the same unit
?VELOCITY %     [...] = {NAME}_epsilon(velocity, 'm/s')       the same for the g* above
%
% Self-check: {NAME}_epsilon('check')
%
% Written by: restitution export --lang {LANGUAGE} {OPTIONS} --name {NAME}
    if ischar(u)
        self_check();
        return
    end
    u = double(u);
    if nargin > 1
?VELOCITY         if ischar(g_star)
?VELOCITY             g_star = {G_STAR}; % m/s
?VELOCITY         end
        u = {U_AT_G_STAR} * (abs(u) ./ g_star).^0.2;
    end
    shape = size(u);
    u = u(:);
?LAW     inside = u >= {LOW};
!LAW     inside = u >= {LOW} & u <= {HIGH};
    u(~inside) = {LOW};
    u(u == 0) = 0; % -0
    [row, distance, width, periods] = locate(u);
    c = table();
    c = c(row + 1, :);
    rise = zeros(size(u));
    for k = {DEGREE}:-1:1
        rise = (rise + c(:, k + 1)) .* distance;
    end
    value = c(:, 1) + rise;
    epsilon = pow2(value, -5 * periods);
    if nargout > 1
        loss = (1 - c(:, 1)) - rise;
?LAW         loss(periods > 0) = 1 - epsilon(periods > 0);
?NEAR         near = row < {NEAR_ROW};
?NEAR !ROOT         x = u(near);
?NEAR ?ROOT         x = sqrt(u(near));
?NEAR         sum = zeros(size(x));
?NEAR         for c_k = fliplr(near_zero())
?NEAR             sum = sum .* x + c_k;
?NEAR         end
?NEAR         loss(near) = u(near) .* sum;
        loss(~inside) = NaN;
        loss = reshape(loss, shape);
    end
    if nargout > 2
        slope = zeros(size(u));
        for k = {DEGREE}:-1:1
            slope = slope .* distance + k * c(:, k + 1);
        end
        slope = -pow2(slope, -width - {FALL} * periods);
        slope(~inside) = NaN;
        slope = reshape(slope, shape);
    end
    epsilon(~inside) = NaN;
    epsilon = reshape(epsilon, shape);
end

% The row of u from 0, the distance to the end of its piece, the exponent of its width, and how many periods of the law at
% infinity lie between.
function [row, distance, width, periods] = locate(u)
    periods = zeros(size(u));
    shifted = u + {SHIFT};
    first = repmat({FIRST}, size(u));
?LAW     u = min(u, {HIGH});
?LAW     far = u >= {LAW_FROM};
?LAW     [~, octave] = log2(u(far));
?LAW     [~, from] = log2({LAW_FROM});
?LAW     periods(far) = floor((octave - from) / {OCTAVES});
?LAW     shifted(far) = pow2(u(far), -{OCTAVES} * periods(far));
?LAW     first(far) = {LAW_FIRST} - {LAW_ROW};
    [mantissa, exponent] = log2(shifted);
    part = (2 * mantissa - 1) * 2^{BITS};
    piece = floor(part);
    row = (exponent + 1022) * 2^{BITS} + piece - first;
    row = min(max(row, 0), {LAST_ROW});
    distance = 1 - (part - piece);
    width = exponent - 1 - {BITS};
end

% The polynomial of each piece, in the distance to its end as a part of its width, constant first.
function c = table()
    persistent kept
    if isempty(kept)
        kept = [
{TABLE}
        ];
    end
    c = kept;
end
?NEAR 
?NEAR function c = near_zero()
?NEAR     c = [{NEAR}];
?NEAR end

function self_check()
    check = [ % u, certified epsilon and 1 - epsilon
{POINTS}
    ];
    [epsilon, loss] = {NAME}_epsilon(check(:, 1));
    worst = max(abs(epsilon ./ check(:, 2) - 1));
    worst_loss = max(abs(loss - check(:, 3)) ./ max(check(:, 3), (check(:, 3) == 0)));
    fprintf('largest relative errors %.2e of %.2e, %.2e of %.2e\n', worst, {TOLERANCE}, worst_loss, {LOSS_BOUND});
    assert(worst <= {TOLERANCE} && worst_loss <= {LOSS_BOUND});
end
"#;
