import tseslint from "typescript-eslint";

export default tseslint.config(
  { ignores: ["dist/**"] },
  ...tseslint.configs.strict,
  { files: ["src/**/*.ts"], rules: { eqeqeq: "error", "prefer-const": "error" } },
);
